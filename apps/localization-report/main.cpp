#include <iostream>

#include "mrpt_ext/pipeline/app_shell.h"
#include "mrpt_ext/pipeline/report_app.h"

int main(int argc, char** argv)
{
  return mrpt_ext::ReportApp(std::cout, std::cerr).run(mrpt_ext::argumentsOf(argc, argv));
}
