/* An importer in C, compiled against the official FMI 3.0 headers, that loads the shared library at run time.
 *
 *   importer3 fly       LIBRARY TOKEN RESOURCES REFERENCE... : flies, saves its state to state.bin half-way
 *   importer3 go-on     the same                             : goes on from state.bin in this process
 *   importer3 endure    the same                             : many instances and many steps in constant memory
 *   importer3 integrate the same, of model exchange          : integrates by itself, through saved states and with derivatives
 *
 * The first REFERENCE is that of an input, the others are outputs, printed in the end with all their digits. With a
 * locale named in the environment (LC_ALL), it is that of the program. Exit status 0: all went as it should. */

#include <dlfcn.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "fmi3Functions.h"

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

static const char *token, *resources;
static fmi3ValueReference input, outputs[16];
static size_t output_count;
/* Errors and what is discarded; some are meant. */
static int complaints;

static void logger(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message)
{
    fprintf(stderr, "%s %d %s: %s\n", (const char *)environment, (int)status, category, message);
    complaints += status >= fmi3Discard;
}

static fmi3Instance of_co_simulation(char *name)
{
    LOAD(fmi3InstantiateCoSimulation);
    fmi3Instance instance = fmi3InstantiateCoSimulation(name, token, resources, fmi3False, fmi3False, fmi3False,
                                                        fmi3False, NULL, 0, name, logger, NULL);
    CHECK(instance != NULL);
    return instance;
}

static fmi3Instance of_model_exchange(char *name)
{
    LOAD(fmi3InstantiateModelExchange);
    fmi3Instance instance = fmi3InstantiateModelExchange(name, token, resources, fmi3False, fmi3False, name, logger);
    CHECK(instance != NULL);
    return instance;
}

/* Trimmed, at time 0. */
static fmi3Instance initialised(fmi3Instance instance)
{
    LOAD(fmi3EnterInitializationMode);
    LOAD(fmi3ExitInitializationMode);
    CHECK(fmi3EnterInitializationMode(instance, fmi3False, 0.0, 0.0, fmi3False, 0.0) == fmi3OK);
    CHECK(fmi3ExitInitializationMode(instance) == fmi3OK);
    return instance;
}

enum { HALF = 20, END = 40 };

static fmi3Status one_step(fmi3Instance instance, double point, double size)
{
    LOAD(fmi3DoStep);
    fmi3Boolean events = fmi3True, ends = fmi3True, returns = fmi3True;
    fmi3Float64 reached = -1.0;
    fmi3Status status = fmi3DoStep(instance, point, size, fmi3False, &events, &ends, &returns, &reached);
    if (status == fmi3OK)
        CHECK(!events && !ends && !returns && fabs(reached - point - size) < 1e-9);
    return status;
}

static void set(fmi3Instance instance, fmi3Float64 value)
{
    LOAD(fmi3SetFloat64);
    CHECK(fmi3SetFloat64(instance, &input, 1, &value, 1) == fmi3OK);
}

static void step(fmi3Instance instance, int from, int to)
{
    for (int i = from; i < to; i++) {
        set(instance, 0.01 * (i % 5));
        CHECK(one_step(instance, 0.013 * i, 0.013) == fmi3OK);
    }
}

/* The outputs as hexadecimal floating-point numbers: bit for bit, with the decimal sign of the locale. */
static void print(fmi3Instance instance)
{
    LOAD(fmi3GetFloat64);
    fmi3Float64 values[16];
    CHECK(fmi3GetFloat64(instance, outputs, output_count, values, output_count) == fmi3OK);
    for (size_t i = 0; i < output_count; i++) {
        unsigned long long bits;
        memcpy(&bits, &values[i], sizeof bits);
        printf("%016llx %.6g\n", bits, values[i]);
    }
}

/* The present state as bytes, to be freed. */
static fmi3Byte *saved(fmi3Instance instance, size_t *size)
{
    LOAD(fmi3GetFMUState);
    LOAD(fmi3SerializedFMUStateSize);
    LOAD(fmi3SerializeFMUState);
    LOAD(fmi3FreeFMUState);
    fmi3FMUState state = NULL;
    CHECK(fmi3GetFMUState(instance, &state) == fmi3OK);
    CHECK(fmi3SerializedFMUStateSize(instance, state, size) == fmi3OK);
    fmi3Byte *bytes = malloc(*size);
    CHECK(bytes != NULL && fmi3SerializeFMUState(instance, state, bytes, *size) == fmi3OK);
    CHECK(fmi3FreeFMUState(instance, &state) == fmi3OK && state == NULL);
    return bytes;
}

static void save(fmi3Instance instance)
{
    size_t size = 0;
    fmi3Byte *bytes = saved(instance, &size);
    FILE *file = fopen("state.bin", "wb");
    CHECK(file != NULL && fwrite(bytes, 1, size, file) == size && fclose(file) == 0);
    free(bytes);
}

static fmi3Status restored(fmi3Instance instance, const fmi3Byte *bytes, size_t size)
{
    LOAD(fmi3DeserializeFMUState);
    LOAD(fmi3SetFMUState);
    LOAD(fmi3FreeFMUState);
    fmi3FMUState state = NULL;
    fmi3Status status = fmi3DeserializeFMUState(instance, bytes, size, &state);
    CHECK((status == fmi3OK) == (state != NULL));
    if (status == fmi3OK)
        status = fmi3SetFMUState(instance, state);
    CHECK(fmi3FreeFMUState(instance, &state) == fmi3OK && state == NULL);
    return status;
}

/* Also tries it with one byte changed and one missing, which must be refused and ends the instance: the right bytes
 * lead back. */
static void restore(fmi3Instance instance)
{
    static fmi3Byte bytes[1 << 20];
    FILE *file = fopen("state.bin", "rb");
    CHECK(file != NULL);
    size_t size = fread(bytes, 1, sizeof bytes, file);
    CHECK(size > 0 && size < sizeof bytes && fclose(file) == 0);
    CHECK(restored(instance, bytes, size - 1) == fmi3Error);
    bytes[size / 2] ^= 1;
    CHECK(restored(instance, bytes, size) == fmi3Error && complaints == 2);
    bytes[size / 2] ^= 1;
    CHECK(restored(instance, bytes, size) == fmi3OK);
}

static void finish(fmi3Instance instance)
{
    LOAD(fmi3Terminate);
    LOAD(fmi3FreeInstance);
    CHECK(fmi3Terminate(instance) == fmi3OK);
    fmi3FreeInstance(instance);
}

/* Flies half of the way; an error (a step from the wrong point) ends the flight, the state before it leads back. */
static void fly(void)
{
    fmi3Instance instance = initialised(of_co_simulation("fly"));
    step(instance, 0, HALF);
    save(instance);
    size_t size = 0;
    fmi3Byte *bytes = saved(instance, &size);
    CHECK(one_step(instance, 7.0, 0.013) == fmi3Error && complaints == 1);
    CHECK(one_step(instance, 0.013 * HALF, 0.013) == fmi3Error && complaints == 2);
    CHECK(restored(instance, bytes, size) == fmi3OK);
    free(bytes);
    step(instance, HALF, END);
    print(instance);
    finish(instance);
}

enum { MOST_STATES = 4096, INTEGRATED = 50 };
static const double SIZE = 1e-3;

static size_t states;
static double x[MOST_STATES], slopes[4][MOST_STATES], moved[MOST_STATES];

static void rates(fmi3Instance instance, double time, const double *at, double *slope)
{
    LOAD(fmi3SetTime);
    LOAD(fmi3SetContinuousStates);
    LOAD(fmi3GetContinuousStateDerivatives);
    CHECK(fmi3SetTime(instance, time) == fmi3OK);
    CHECK(fmi3SetContinuousStates(instance, at, states) == fmi3OK);
    CHECK(fmi3GetContinuousStateDerivatives(instance, slope, states) == fmi3OK);
}

/* Steps of the classical method of fourth order. */
static void integrate_over(fmi3Instance instance, int from, int to)
{
    LOAD(fmi3GetContinuousStates);
    LOAD(fmi3SetTime);
    LOAD(fmi3SetContinuousStates);
    LOAD(fmi3CompletedIntegratorStep);
    static const double shares[4] = {0.0, 0.5, 0.5, 1.0}, weights[4] = {1.0, 2.0, 2.0, 1.0};
    CHECK(fmi3GetContinuousStates(instance, x, states) == fmi3OK);
    for (int i = from; i < to; i++) {
        double time = SIZE * i;
        set(instance, 0.01 * (i / 10 % 5));
        for (int stage = 0; stage < 4; stage++) {
            for (size_t k = 0; k < states; k++)
                moved[k] = x[k] + (stage > 0 ? shares[stage] * SIZE * slopes[stage - 1][k] : 0.0);
            rates(instance, time + shares[stage] * SIZE, moved, slopes[stage]);
        }
        for (size_t k = 0; k < states; k++)
            for (int stage = 0; stage < 4; stage++)
                x[k] += SIZE / 6.0 * weights[stage] * slopes[stage][k];
        fmi3Boolean events = fmi3True, ends = fmi3True;
        CHECK(fmi3SetTime(instance, SIZE * (i + 1)) == fmi3OK);
        CHECK(fmi3SetContinuousStates(instance, x, states) == fmi3OK);
        CHECK(fmi3CompletedIntegratorStep(instance, fmi3False, &events, &ends) == fmi3OK && !events && !ends);
    }
}

/* The outputs' directional derivatives by the input are near what a small change of it makes. */
static void differentiate(fmi3Instance instance)
{
    LOAD(fmi3GetDirectionalDerivative);
    LOAD(fmi3GetFloat64);
    const double change = 1e-4, seed = 1.0;
    double slope[16], values[2][16], present;
    CHECK(fmi3GetFloat64(instance, &input, 1, &present, 1) == fmi3OK);
    CHECK(fmi3GetDirectionalDerivative(instance, outputs, output_count, &input, 1, &seed, 1, slope, output_count) ==
          fmi3OK);
    for (int side = 0; side < 2; side++) {
        set(instance, present + (side ? change : -change));
        CHECK(fmi3GetFloat64(instance, outputs, output_count, values[side], output_count) == fmi3OK);
    }
    set(instance, present);
    int moving = 0;
    for (size_t i = 0; i < output_count; i++) {
        double expected = (values[1][i] - values[0][i]) / (2.0 * change);
        CHECK(fabs(slope[i] - expected) <= 1e-3 * fabs(expected) + 1e-6);
        moving += slope[i] != 0.0;
    }
    CHECK(moving > 0);
}

/* Half of the way, and the other half in an instance that knows the bytes of the first alone. */
static void integrate(void)
{
    LOAD(fmi3GetNumberOfContinuousStates);
    LOAD(fmi3GetNumberOfEventIndicators);
    LOAD(fmi3UpdateDiscreteStates);
    LOAD(fmi3EnterContinuousTimeMode);
    LOAD(fmi3FreeInstance);
    fmi3Instance first = initialised(of_model_exchange("first"));
    size_t indicators = 9, size = 0;
    CHECK(fmi3GetNumberOfContinuousStates(first, &states) == fmi3OK && states > 0 && states <= MOST_STATES);
    CHECK(fmi3GetNumberOfEventIndicators(first, &indicators) == fmi3OK && indicators == 0);
    fmi3Boolean update = fmi3True, ends = fmi3True, nominals = fmi3True, values = fmi3True, next = fmi3True;
    fmi3Float64 time = -1.0;
    CHECK(fmi3UpdateDiscreteStates(first, &update, &ends, &nominals, &values, &next, &time) == fmi3OK);
    CHECK(!update && !ends && !nominals && !values && !next);
    CHECK(fmi3EnterContinuousTimeMode(first) == fmi3OK);
    integrate_over(first, 0, INTEGRATED / 2);
    fmi3Byte *bytes = saved(first, &size);
    fmi3FreeInstance(first);
    fmi3Instance second = of_model_exchange("second");
    CHECK(restored(second, bytes, size) == fmi3OK);
    free(bytes);
    integrate_over(second, INTEGRATED / 2, INTEGRATED);
    differentiate(second);
    print(second);
    finish(second);
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
    LOAD(fmi3FreeInstance);
    for (int i = 0; i < 20; i++)
        fmi3FreeInstance(of_co_simulation("early"));
    long early = resident();
    for (int i = 0; i < 180; i++)
        fmi3FreeInstance(of_co_simulation("late"));
    fmi3Instance instance = initialised(of_co_simulation("steps"));
    step(instance, 0, HALF);
    long before = resident();
    for (int i = 0; i < 20000; i++)
        CHECK(one_step(instance, 0.013 * HALF + 1e-7 * i, 1e-7) == fmi3OK);
    printf("%ld %ld %ld\n", early, before, resident());
    /* Pages of 4 KiB: 1 MiB and 8 MiB. */
    CHECK(resident() - before <= 256);
    finish(instance);
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
    token = argv[3];
    resources = argv[4];
    input = (fmi3ValueReference)strtoul(argv[5], NULL, 10);
    for (int i = 6; i < argc && output_count < 16; i++)
        outputs[output_count++] = (fmi3ValueReference)strtoul(argv[i], NULL, 10);
    if (strcmp(argv[1], "fly") == 0) {
        fly();
    } else if (strcmp(argv[1], "go-on") == 0) {
        fmi3Instance instance = of_co_simulation("go on");
        restore(instance);
        step(instance, HALF, END);
        print(instance);
        finish(instance);
    } else if (strcmp(argv[1], "integrate") == 0) {
        integrate();
    } else {
        endure();
    }
    CHECK(dlclose(library) == 0);
    return 0;
}
