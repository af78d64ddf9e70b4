#include <iostream>

#include "mrpt_ext/app/app_shell.h"
#include "mrpt_ext/app/report_app.h"

int main(int argc, char** argv)
{
  return mrpt_ext::ReportApp(std::cout, std::cerr).run(mrpt_ext::argumentsOf(argc, argv));
}
