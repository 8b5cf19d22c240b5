/* Loaded before the program (LD_PRELOAD): a GSL of another version, whose normal quantile is off by one part in a million. */
#include <math.h>

char const* gsl_version = "9.9";

double gsl_cdf_ugaussian_Pinv(double p) {
    (void)p;
    return 1.959963984540054 * (1 + 1e-6);
}
