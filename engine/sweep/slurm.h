#pragma once
// The runs of a study as job arrays of Slurm: submitted with sbatch, followed with squeue. Each task is `talus
// sweep … --only run`, and what has ended is seen in the runs' folders, so that the cluster's accounting is not
// needed.
#include <map>
#include <string>
#include <vector>

#include "scene/study.h"

namespace talus {

class SlurmJob {
 public:
  // `command`: the words before --only. Knows the job that was submitted for this study before, where there is
  // one.
  SlurmJob(const Study& study, std::vector<std::string> command);

  void submit(const std::vector<std::size_t>& runs);  // RunError with sbatch's words
  bool running();                                     // or waiting to run; asks squeue
  std::string states() const;                         // "2 running, 10 pending", when last asked
  std::string name() const;                           // "123", "123, 124"
  double pause();                                     // s until asking again is worth it
  // How the tasks of these runs ended, as far as Slurm still knows.
  std::map<std::size_t, std::string> ends(const std::vector<std::size_t>& runs) const;

 private:
  struct Array {
    std::string id;
    std::vector<std::string> runs;  // names; the first is task 1
  };
  void submit_array(const std::vector<std::string>& names);
  std::string ids() const;
  void read();
  void write() const;

  const Study& study_;
  std::vector<std::string> command_;
  std::vector<Array> arrays_;
  std::map<std::string, std::size_t> states_;
  double pause_ = 0.5;
};

}  // namespace talus
