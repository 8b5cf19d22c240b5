/// GSL's own error handler ends the process; here its routines say by their return value what went wrong.
#pragma once

#include <gsl/gsl_errno.h>

namespace overturn {

/// Guard: GSL does not abort while one of these lives.
class GslQuiet {
  public:
    GslQuiet() : before_(gsl_set_error_handler_off()) {}
    ~GslQuiet() { gsl_set_error_handler(before_); }
    GslQuiet(GslQuiet const&) = delete;
    GslQuiet& operator=(GslQuiet const&) = delete;
    GslQuiet(GslQuiet&&) = delete;
    GslQuiet& operator=(GslQuiet&&) = delete;

  private:
    gsl_error_handler_t* before_;
};

}  // namespace overturn
