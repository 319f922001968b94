/* Flies the unpacked FMU through its C interface: an elevator pulse, printed every half second.
 *
 *   python3 -m zipfile -e target/fmu/FlexibleAircraft.fmu target/unpacked
 *   library=target/unpacked/binaries/linux64/FlexibleAircraft.so
 *   cc -std=c11 -I fmi-headers examples/fly.c $library -o target/unpacked/fly
 *   target/unpacked/fly "$PWD/target/unpacked"
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "flexible_aircraft_fmi2.h"

static char xml[1 << 20];

/* What follows a mark in the model description. */
static const char *after(const char *mark)
{
    const char *found = strstr(xml, mark);
    if (!found) {
        fprintf(stderr, "modelDescription.xml lacks %s: this flight is one of the generic business jet\n", mark);
        exit(1);
    }
    return found + strlen(mark);
}

#define REFERENCE(name) (fmi2ValueReference)strtoul(after("name=\"" name "\" valueReference=\""), NULL, 10)

/* A warning, such as that of a trim beyond the aircraft's limits, is no failure. */
static int fails(fmi2Status status)
{
    return status > fmi2Warning;
}

int main(int count, char *arguments[])
{
    char path[4096], resources[4096], guid[64];
    snprintf(path, sizeof path, "%s/modelDescription.xml", count > 1 ? arguments[1] : "");
    snprintf(resources, sizeof resources, "file://%s/resources", count > 1 ? arguments[1] : "");
    FILE *file = fopen(path, "rb");
    if (!file || !fread(xml, 1, sizeof xml - 1, file) || sscanf(after("guid=\""), "%63[^\"]", guid) != 1)
        return fprintf(stderr, "usage: fly FOLDER, the absolute path of the unpacked FMU\n"), 1;
    fclose(file);
    const fmi2ValueReference elevator = REFERENCE("elevator");
    const fmi2ValueReference outputs[] = {
        REFERENCE("attitude.pitch"), REFERENCE("load_factor.z"), REFERENCE("deflection.wing_tip_right.up")};
    const fmi2CallbackFunctions callbacks = {0};

    fmi2Component jet = fmi2Instantiate("jet", fmi2CoSimulation, guid, resources, &callbacks, 0, 0);
    int bad = !jet || fails(fmi2SetupExperiment(jet, 0, 0.0, 0.0, 0, 0.0));
    bad = bad || fails(fmi2EnterInitializationMode(jet)) || fails(fmi2ExitInitializationMode(jet));
    for (int step = 0; !bad && step < 400; step++) {
        const fmi2Real angle = step < 150 ? -0.02 : 0.0; /* rad about the trim, nose-up */
        fmi2Real values[3];
        bad = fails(fmi2SetReal(jet, &elevator, 1, &angle)) || fails(fmi2DoStep(jet, 0.01 * step, 0.01, 1))
              || fails(fmi2GetReal(jet, outputs, 3, values));
        if (!bad && step % 50 == 49)
            printf("%.1f s  pitch %+.6f rad  load factor %.6f  wing tip %.6f m up\n", 0.01 * (step + 1), values[0],
                   values[1], values[2]);
    }
    if (bad)
        fprintf(stderr, "the flight has failed; a logger among the callbacks would say why\n");
    fmi2FreeInstance(jet);
    return bad;
}
