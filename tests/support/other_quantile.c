/* Loaded before the program (LD_PRELOAD): a GSL whose normal quantile is off by one part in a million. */
#include <math.h>

double gsl_cdf_ugaussian_Pinv(double p) {
    (void)p;
    return 1.959963984540054 * (1 + 1e-6);
}
