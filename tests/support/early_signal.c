/* A library that, preloaded, sends its process the signal that OVERTURN_EARLY_SIGNAL names, before main. */
#include <signal.h>
#include <stdlib.h>

__attribute__((constructor)) static void send_early(void) {
    char const* const number = getenv("OVERTURN_EARLY_SIGNAL");
    if (number != NULL) {
        int const wished = atoi(number);
        unsetenv("OVERTURN_EARLY_SIGNAL"); /* not for what MPI starts */
        raise(wished);
    }
}
