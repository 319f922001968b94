/* An importer in C, compiled against the official FMI 2.0 headers, that loads the shared library at run time.
 *
 *   importer fly     LIBRARY GUID RESOURCES REFERENCE... : flies, saves its state to state.bin half-way
 *   importer go-on   the same                            : goes on from state.bin in this process
 *   importer endure  the same                            : many instances and many steps in constant memory
 *
 * The first REFERENCE is that of an input, the others are outputs, printed in the end with all their digits. With a
 * locale named in the environment (LC_ALL), it is that of the program. Exit status 0: all went as it should. */

#include <dlfcn.h>
#include <locale.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "fmi2Functions.h"

#define CHECK(condition)                                                            \
    do {                                                                            \
        if (!(condition)) {                                                         \
            fprintf(stderr, "%s:%d: %s does not hold\n", __FILE__, __LINE__, #condition); \
            exit(1);                                                                \
        }                                                                           \
    } while (0)

static void *library;

/* Declares `name` as a pointer to the library's function of that name. */
#define LOAD(name)                              \
    name##TYPE *name = (name##TYPE *)dlsym(library, #name); \
    CHECK(name != NULL)

static const char *guid, *resources;
static fmi2ValueReference input, outputs[16];
static size_t output_count;

static void logger(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status, fmi2String category,
                   fmi2String message, ...)
{
    va_list arguments;
    (void)environment;
    va_start(arguments, message);
    fprintf(stderr, "%s %d %s: ", instance, (int)status, category);
    vfprintf(stderr, message, arguments);
    fputc('\n', stderr);
    va_end(arguments);
}

static const fmi2CallbackFunctions callbacks = {logger, calloc, free, NULL, NULL};

static fmi2Component instantiated(const char *name)
{
    LOAD(fmi2Instantiate);
    fmi2Component component =
        fmi2Instantiate(name, fmi2CoSimulation, guid, resources, &callbacks, fmi2False, fmi2False);
    CHECK(component != NULL);
    return component;
}

/* Trimmed, at time 0. */
static fmi2Component ready(const char *name)
{
    LOAD(fmi2SetupExperiment);
    LOAD(fmi2EnterInitializationMode);
    LOAD(fmi2ExitInitializationMode);
    fmi2Component component = instantiated(name);
    CHECK(fmi2SetupExperiment(component, fmi2False, 0.0, 0.0, fmi2False, 0.0) == fmi2OK);
    CHECK(fmi2EnterInitializationMode(component) == fmi2OK);
    CHECK(fmi2ExitInitializationMode(component) == fmi2OK);
    return component;
}

enum { HALF = 20, END = 40 };

static void step(fmi2Component component, int from, int to)
{
    LOAD(fmi2SetReal);
    LOAD(fmi2DoStep);
    for (int i = from; i < to; i++) {
        fmi2Real value = 0.01 * (i % 5);
        CHECK(fmi2SetReal(component, &input, 1, &value) == fmi2OK);
        CHECK(fmi2DoStep(component, 0.013 * i, 0.013, fmi2False) == fmi2OK);
    }
}

/* The outputs as hexadecimal floating-point numbers: bit for bit, with the decimal sign of the locale. */
static void print(fmi2Component component)
{
    LOAD(fmi2GetReal);
    fmi2Real values[16];
    CHECK(fmi2GetReal(component, outputs, output_count, values) == fmi2OK);
    for (size_t i = 0; i < output_count; i++) {
        unsigned long long bits;
        memcpy(&bits, &values[i], sizeof bits);
        printf("%016llx %.6g\n", bits, values[i]);
    }
}

static void save(fmi2Component component)
{
    LOAD(fmi2GetFMUstate);
    LOAD(fmi2SerializedFMUstateSize);
    LOAD(fmi2SerializeFMUstate);
    LOAD(fmi2FreeFMUstate);
    fmi2FMUstate state = NULL;
    size_t size = 0;
    CHECK(fmi2GetFMUstate(component, &state) == fmi2OK);
    CHECK(fmi2SerializedFMUstateSize(component, state, &size) == fmi2OK);
    fmi2Byte *bytes = malloc(size);
    CHECK(bytes != NULL && fmi2SerializeFMUstate(component, state, bytes, size) == fmi2OK);
    FILE *file = fopen("state.bin", "wb");
    CHECK(file != NULL && fwrite(bytes, 1, size, file) == size && fclose(file) == 0);
    free(bytes);
    CHECK(fmi2FreeFMUstate(component, &state) == fmi2OK && state == NULL);
}

/* Also tries it with one byte changed and one missing, which must be refused. */
static void restore(fmi2Component component)
{
    LOAD(fmi2DeSerializeFMUstate);
    LOAD(fmi2SetFMUstate);
    LOAD(fmi2FreeFMUstate);
    static fmi2Byte bytes[1 << 20];
    FILE *file = fopen("state.bin", "rb");
    CHECK(file != NULL);
    size_t size = fread(bytes, 1, sizeof bytes, file);
    CHECK(size > 0 && size < sizeof bytes && fclose(file) == 0);
    fmi2FMUstate state = NULL;
    CHECK(fmi2DeSerializeFMUstate(component, bytes, size - 1, &state) == fmi2Error);
    bytes[size / 2] ^= 1;
    CHECK(fmi2DeSerializeFMUstate(component, bytes, size, &state) == fmi2Error && state == NULL);
    bytes[size / 2] ^= 1;
    CHECK(fmi2DeSerializeFMUstate(component, bytes, size, &state) == fmi2OK);
    CHECK(fmi2SetFMUstate(component, state) == fmi2OK);
    CHECK(fmi2FreeFMUstate(component, &state) == fmi2OK);
}

static void finish(fmi2Component component)
{
    LOAD(fmi2Terminate);
    LOAD(fmi2FreeInstance);
    CHECK(fmi2Terminate(component) == fmi2OK);
    fmi2FreeInstance(component);
}

/* Resident memory in pages. */
static long resident(void)
{
    long size, pages = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    CHECK(file != NULL && fscanf(file, "%ld %ld", &size, &pages) == 2);
    fclose(file);
    return pages;
}

static void endure(void)
{
    LOAD(fmi2FreeInstance);
    LOAD(fmi2DoStep);
    for (int i = 0; i < 20; i++)
        fmi2FreeInstance(instantiated("early"));
    long early = resident();
    for (int i = 0; i < 180; i++)
        fmi2FreeInstance(instantiated("late"));
    fmi2Component component = ready("steps");
    step(component, 0, HALF);
    long before = resident();
    for (int i = 0; i < 20000; i++)
        CHECK(fmi2DoStep(component, 0.013 * HALF + 1e-7 * i, 1e-7, fmi2False) == fmi2OK);
    printf("%ld %ld %ld\n", early, before, resident());
    /* Pages of 4 KiB: 1 MiB and 8 MiB. */
    CHECK(resident() - before <= 256);
    finish(component);
    CHECK(resident() - early <= 2048);
}

int main(int argc, char **argv)
{
    CHECK(argc > 6);
    CHECK(setlocale(LC_ALL, "") != NULL);
    fprintf(stderr, "decimal sign: %s\n", localeconv()->decimal_point);
    library = dlopen(argv[2], RTLD_NOW | RTLD_LOCAL);
    if (library == NULL)
        fprintf(stderr, "%s\n", dlerror());
    CHECK(library != NULL);
    guid = argv[3];
    resources = argv[4];
    input = (fmi2ValueReference)strtoul(argv[5], NULL, 10);
    for (int i = 6; i < argc && output_count < 16; i++)
        outputs[output_count++] = (fmi2ValueReference)strtoul(argv[i], NULL, 10);
    if (strcmp(argv[1], "fly") == 0) {
        fmi2Component component = ready("fly");
        step(component, 0, HALF);
        save(component);
        step(component, HALF, END);
        print(component);
        finish(component);
    } else if (strcmp(argv[1], "go-on") == 0) {
        fmi2Component component = instantiated("go on");
        restore(component);
        step(component, HALF, END);
        print(component);
        finish(component);
    } else {
        endure();
    }
    CHECK(dlclose(library) == 0);
    return 0;
}
