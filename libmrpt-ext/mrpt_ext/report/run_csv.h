#pragma once

#include "mrpt_ext/evaluation/run_record.h"
#include "mrpt_ext/files/atomic_file.h"

namespace mrpt_ext
{
// The tables that a trial leaves. Unix time [s], lengths in metres, covariances [m^2, rad^2].

/// Writes steps.csv: `t,method,x,y,phi_deg,cxx,cxy,cyy,cpp,modes,w_best,ess,verdict`, every estimate of every method,
/// ordered by time and then as the methods are listed. phi_deg and cpp are empty where no heading is known, ess where
/// there are no particles.
void stepsCsv(const RunRecord& record, const TextSink& write);

/// Writes hypotheses.csv: `t,rank,x,y,phi_deg,weight,source` in the order given; rank 0 is the best.
void hypothesesCsv(const DiskBackedSequence<HypothesisRow>& hypotheses, const TextSink& write);

/// Writes objects.csv: `t,label,x,y,cxx,cxy,cyy,x_robot,y_robot`, detected objects that are no landmarks, in the
/// map frame with covariance and in the robot frame.
void objectsCsv(const DiskBackedSequence<ObjectRow>& objects, const TextSink& write);

/// Writes biases.csv: `t,bias,mean,std`, the estimated biases after every frame.
void biasesCsv(const DiskBackedSequence<BiasRow>& biases, const TextSink& write);
}  // namespace mrpt_ext
