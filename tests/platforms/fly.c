/* Flies an FMU through its C interface and prints every output as bits, so that platforms can be compared.
 *
 *   fly LIBRARY GUID RESOURCES MODEL INPUT:AMPLITUDE,... OUTPUT,...
 *
 * RESOURCES is a URI; MODEL, INPUT and OUTPUT are value references, AMPLITUDE is how far an input is moved. All
 * arithmetic here is exact or a single rounding: what differs, the library has made different. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "flexible_aircraft_fmi2.h"

#ifdef _WIN32
#include <windows.h>
#define OPEN(path) ((void *)LoadLibraryA(path))
#define FIND(library, name) ((void *)GetProcAddress((HMODULE)(library), name))
#define REASON() "see GetLastError"
#else
#include <dlfcn.h>
#define OPEN(path) dlopen(path, RTLD_NOW | RTLD_LOCAL)
#define FIND(library, name) dlsym(library, name)
#define REASON() dlerror()
#endif

enum { MODELS = 5, STEPS = 20, STEPS_PER_LINE = 5, MOST = 1000 };
static const double STEP = 0.01;

static void *library;

static void *function(const char *name)
{
    void *found = FIND(library, name);
    if (!found) {
        fprintf(stderr, "%s is missing\n", name);
        exit(1);
    }
    return found;
}

#define CALL(name) ((__typeof__(&name))function(#name))
#define OK(name, ...) require(CALL(name)(__VA_ARGS__), #name)

static void require(fmi2Status status, const char *name)
{
    if (status != fmi2OK) {
        fprintf(stderr, "%s returned %d\n", name, (int)status);
        exit(1);
    }
}

static void log_line(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status, fmi2String category,
                     fmi2String message, ...)
{
    (void)environment;
    fprintf(stderr, "%s [%d, %s] %s\n", instance, (int)status, category, message);
}

/* Reads value references, each perhaps with a number; returns how many. */
static size_t read_list(char *text, fmi2ValueReference references[], double numbers[])
{
    size_t count = 0;
    for (char *word = strtok(text, ","); word && count < MOST; word = strtok(NULL, ",")) {
        char *number = strchr(word, ':');
        references[count] = (fmi2ValueReference)strtoul(word, NULL, 10);
        numbers[count++] = number ? strtod(number + 1, NULL) : 0.0;
    }
    return count;
}

static void print_bits(double value)
{
    unsigned int half[2];
    memcpy(half, &value, sizeof half);
    printf(" %08x%08x", half[1], half[0]);
}

/* FNV-1a of the serialised state. */
static void print_state(fmi2Component aircraft)
{
    fmi2FMUstate state = NULL;
    size_t size = 0;
    OK(fmi2GetFMUstate, aircraft, &state);
    OK(fmi2SerializedFMUstateSize, aircraft, state, &size);
    unsigned char *bytes = malloc(size);
    OK(fmi2SerializeFMUstate, aircraft, state, (fmi2Byte *)bytes, size);
    unsigned int hash = 2166136261u;
    for (size_t i = 0; i < size; i++)
        hash = (hash ^ bytes[i]) * 16777619u;
    printf("state of %u bytes: %08x\n", (unsigned int)size, hash);
    free(bytes);
    OK(fmi2FreeFMUstate, aircraft, &state);
}

int main(int count, char *arguments[])
{
    static fmi2ValueReference inputs[MOST], outputs[MOST];
    static double amplitudes[MOST], values[MOST];
    if (count != 7) {
        fprintf(stderr, "six arguments are needed: see fly.c\n");
        return 1;
    }
    library = OPEN(arguments[1]);
    if (!library) {
        fprintf(stderr, "%s does not load: %s\n", arguments[1], REASON());
        return 1;
    }
    fmi2ValueReference model_reference = (fmi2ValueReference)strtoul(arguments[4], NULL, 10);
    size_t input_count = read_list(arguments[5], inputs, amplitudes);
    size_t output_count = read_list(arguments[6], outputs, values);
    fmi2CallbackFunctions callbacks = {log_line, calloc, free, NULL, NULL};

    for (fmi2Integer model = 1; model <= MODELS; model++) {
        fmi2Component aircraft =
            CALL(fmi2Instantiate)("aircraft", fmi2CoSimulation, arguments[2], arguments[3], &callbacks, 0, 0);
        if (!aircraft)
            return 1;
        OK(fmi2SetupExperiment, aircraft, 0, 0.0, 0.0, 0, 0.0);
        OK(fmi2SetInteger, aircraft, &model_reference, 1, &model);
        OK(fmi2EnterInitializationMode, aircraft);
        OK(fmi2ExitInitializationMode, aircraft);
        for (int step = 0; step < STEPS; step++) {
            for (size_t i = 0; i < input_count; i++)
                values[i] = amplitudes[i] * ((step * ((int)i + 3)) % 41 - 20) / 20.0;
            OK(fmi2SetReal, aircraft, inputs, input_count, values);
            OK(fmi2DoStep, aircraft, step * STEP, STEP, 1);
            if ((step + 1) % STEPS_PER_LINE == 0) {
                OK(fmi2GetReal, aircraft, outputs, output_count, values);
                printf("model %d, step %d:", (int)model, step + 1);
                for (size_t i = 0; i < output_count; i++)
                    print_bits(values[i]);
                printf("\n");
            }
        }
        print_state(aircraft);
        OK(fmi2Terminate, aircraft);
        CALL(fmi2FreeInstance)(aircraft);
    }
    return 0;
}
