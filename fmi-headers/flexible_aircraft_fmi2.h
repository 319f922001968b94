/* The C interface of the flexible-aircraft FMU: FMI 2.0, platform "default".
 *
 * Written from the standard's text for those who load the shared library without an FMI toolkit. Importers use the
 * official headers; check.c proves that both say the same. Positions, units and meanings of the variables are in the
 * FMU's modelDescription.xml. */
#ifndef FLEXIBLE_AIRCRAFT_FMI2_H
#define FLEXIBLE_AIRCRAFT_FMI2_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Where the official headers are included first, their types are used and only the prototypes are repeated. */
#ifndef fmi2FunctionTypes_h

typedef void *fmi2Component;            /* an instance */
typedef void *fmi2ComponentEnvironment; /* the importer's own, passed to its callbacks */
typedef void *fmi2FMUstate;             /* a saved state */
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean; /* 0 is false */
typedef char fmi2Char;
typedef const fmi2Char *fmi2String; /* UTF-8 */
typedef char fmi2Byte;

typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef enum { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated } fmi2StatusKind;

/* The message is finished: it is passed as the format, with every per cent sign doubled, and nothing follows it. */
typedef void (*fmi2CallbackLogger)(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status,
                                   fmi2String category, fmi2String message, ...);
typedef void *(*fmi2CallbackAllocateMemory)(size_t count, size_t size);
typedef void (*fmi2CallbackFreeMemory)(void *memory);
typedef void (*fmi2StepFinished)(fmi2ComponentEnvironment environment, fmi2Status status);

/* Only logger and componentEnvironment are used; every member may be NULL. */
typedef struct {
    fmi2CallbackLogger logger;
    fmi2CallbackAllocateMemory allocateMemory;
    fmi2CallbackFreeMemory freeMemory;
    fmi2StepFinished stepFinished;
    fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;

/* Of model exchange: no event is ever ahead. */
typedef struct {
    fmi2Boolean newDiscreteStatesNeeded;
    fmi2Boolean terminateSimulation;
    fmi2Boolean nominalsOfContinuousStatesChanged;
    fmi2Boolean valuesOfContinuousStatesChanged;
    fmi2Boolean nextEventTimeDefined;
    fmi2Real nextEventTime;
} fmi2EventInfo;

#endif

/* Versions: "default" and "2.0". */
const char *fmi2GetTypesPlatform(void);
const char *fmi2GetVersion(void);

/* Making and ending instances. */
fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resource_location,
                              const fmi2CallbackFunctions *functions, fmi2Boolean visible, fmi2Boolean logging_on);
void fmi2FreeInstance(fmi2Component instance);
fmi2Status fmi2SetDebugLogging(fmi2Component instance, fmi2Boolean logging_on, size_t count,
                               const fmi2String categories[]);

/* The life cycle. */
fmi2Status fmi2SetupExperiment(fmi2Component instance, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                               fmi2Real start_time, fmi2Boolean stop_time_defined, fmi2Real stop_time);
fmi2Status fmi2EnterInitializationMode(fmi2Component instance);
fmi2Status fmi2ExitInitializationMode(fmi2Component instance);
fmi2Status fmi2DoStep(fmi2Component instance, fmi2Real current_communication_point, fmi2Real communication_step_size,
                      fmi2Boolean no_set_fmu_state_prior_to_current_point);
fmi2Status fmi2Terminate(fmi2Component instance);
fmi2Status fmi2Reset(fmi2Component instance);

/* Values; there are no Strings. */
fmi2Status fmi2GetReal(fmi2Component instance, const fmi2ValueReference references[], size_t count, fmi2Real values[]);
fmi2Status fmi2GetInteger(fmi2Component instance, const fmi2ValueReference references[], size_t count,
                          fmi2Integer values[]);
fmi2Status fmi2GetBoolean(fmi2Component instance, const fmi2ValueReference references[], size_t count,
                          fmi2Boolean values[]);
fmi2Status fmi2GetString(fmi2Component instance, const fmi2ValueReference references[], size_t count,
                         fmi2String values[]);
fmi2Status fmi2SetReal(fmi2Component instance, const fmi2ValueReference references[], size_t count,
                       const fmi2Real values[]);
fmi2Status fmi2SetInteger(fmi2Component instance, const fmi2ValueReference references[], size_t count,
                          const fmi2Integer values[]);
fmi2Status fmi2SetBoolean(fmi2Component instance, const fmi2ValueReference references[], size_t count,
                          const fmi2Boolean values[]);
fmi2Status fmi2SetString(fmi2Component instance, const fmi2ValueReference references[], size_t count,
                         const fmi2String values[]);

/* Derivatives; those of outputs by time are refused. */
fmi2Status fmi2SetRealInputDerivatives(fmi2Component instance, const fmi2ValueReference references[], size_t count,
                                       const fmi2Integer orders[], const fmi2Real values[]);
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component instance, const fmi2ValueReference references[], size_t count,
                                        const fmi2Integer orders[], fmi2Real values[]);
fmi2Status fmi2GetDirectionalDerivative(fmi2Component instance, const fmi2ValueReference unknowns[],
                                        size_t unknown_count, const fmi2ValueReference knowns[], size_t known_count,
                                        const fmi2Real known_changes[], fmi2Real unknown_changes[]);

/* Saved states. */
fmi2Status fmi2GetFMUstate(fmi2Component instance, fmi2FMUstate *state);
fmi2Status fmi2SetFMUstate(fmi2Component instance, fmi2FMUstate state);
fmi2Status fmi2FreeFMUstate(fmi2Component instance, fmi2FMUstate *state);
fmi2Status fmi2SerializedFMUstateSize(fmi2Component instance, fmi2FMUstate state, size_t *size);
fmi2Status fmi2SerializeFMUstate(fmi2Component instance, fmi2FMUstate state, fmi2Byte bytes[], size_t size);
fmi2Status fmi2DeSerializeFMUstate(fmi2Component instance, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state);

/* Status; all but the last successful time and terminated are discarded. */
fmi2Status fmi2CancelStep(fmi2Component instance);
fmi2Status fmi2GetStatus(fmi2Component instance, const fmi2StatusKind kind, fmi2Status *value);
fmi2Status fmi2GetRealStatus(fmi2Component instance, const fmi2StatusKind kind, fmi2Real *value);
fmi2Status fmi2GetIntegerStatus(fmi2Component instance, const fmi2StatusKind kind, fmi2Integer *value);
fmi2Status fmi2GetBooleanStatus(fmi2Component instance, const fmi2StatusKind kind, fmi2Boolean *value);
fmi2Status fmi2GetStringStatus(fmi2Component instance, const fmi2StatusKind kind, fmi2String *value);

/* Model exchange; refused by an FMU for co-simulation. */
fmi2Status fmi2EnterEventMode(fmi2Component instance);
fmi2Status fmi2NewDiscreteStates(fmi2Component instance, fmi2EventInfo *event_info);
fmi2Status fmi2EnterContinuousTimeMode(fmi2Component instance);
fmi2Status fmi2CompletedIntegratorStep(fmi2Component instance, fmi2Boolean no_set_fmu_state_prior_to_current_point,
                                       fmi2Boolean *enter_event_mode, fmi2Boolean *terminate_simulation);
fmi2Status fmi2SetTime(fmi2Component instance, fmi2Real time);
fmi2Status fmi2SetContinuousStates(fmi2Component instance, const fmi2Real states[], size_t count);
fmi2Status fmi2GetDerivatives(fmi2Component instance, fmi2Real derivatives[], size_t count);
fmi2Status fmi2GetEventIndicators(fmi2Component instance, fmi2Real indicators[], size_t count);
fmi2Status fmi2GetContinuousStates(fmi2Component instance, fmi2Real states[], size_t count);
fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component instance, fmi2Real nominals[], size_t count);

#ifdef __cplusplus
}
#endif

#endif
