/* The logger that the calling side hands to an FMU. FMI 2.0 makes it a variadic C function, which stable
   Rust can call but not define: this one puts the line together and passes it on. */

#include <stdarg.h>
#include <stdio.h>

/* Of Rust: appends a line to the log that `environment` points to. */
void flexible_aircraft_importer_log(void *environment, const char *category, const char *line);

void flexible_aircraft_importer_logger(void *environment, const char *instance, int status,
                                       const char *category, const char *message, ...)
{
    char line[4096];
    va_list arguments;
    (void)instance;
    (void)status;
    va_start(arguments, message);
    vsnprintf(line, sizeof line, message, arguments);
    va_end(arguments);
    flexible_aircraft_importer_log(environment, category, line);
}
