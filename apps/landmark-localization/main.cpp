#if __has_include(<malloc.h>)
#include <malloc.h>  // M_TRIM_THRESHOLD: glibc
#endif

#include <iostream>

#include "mrpt_ext/app/apps.h"
#include "mrpt_ext/maps/register_all_classes.h"

int main(int argc, char** argv)
{
#ifdef M_TRIM_THRESHOLD
  // Loading a log and starting a filter take memory that the hours after them do not need: it is given back.
  mallopt(M_TRIM_THRESHOLD, 128 * 1024);
#endif
  mrpt_ext::registerAllClasses();
  return mrpt_ext::runLandmarkLocalization(mrpt_ext::argumentsOf(argc, argv), std::cout, std::cerr);
}
