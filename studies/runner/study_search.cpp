// SPDX-License-Identifier: Apache-2.0
#include <nlopt.h>

#include <algorithm>
#include <memory>

#include "geometry/system/assertion.h"
#include "studies/runner/study.h"

namespace hapticell::studies {

namespace {

/// What a missed requirement adds to the objective for each unit by which it is missed. Half: a large objective may win
/// over a requirement; twice: the search sees less of the objective near a bound.
constexpr double kPenalty = 1e3;
/// The objective of a variant without one: worse than all others. Half and twice as well.
constexpr double kNoAnswer = 1e6;
/// First step of a local search, as a share of each range. Half: more local; twice: half of the range.
constexpr double kFirstStep = 0.25;

struct NamedAlgorithm {
  const char* name;
  nlopt_algorithm algorithm;
};
/// Local ones first. Nelder and Mead 1965; Rowan 1990; Powell 1994 and 2009; Kaelo and Ali 2006; Runarsson and Yao 2005;
/// Jones 1993; da Silva Santos 2010.
constexpr NamedAlgorithm kAlgorithms[] = {{"nelder-mead", NLOPT_LN_NELDERMEAD}, {"sbplx", NLOPT_LN_SBPLX},
                                          {"cobyla", NLOPT_LN_COBYLA},          {"bobyqa", NLOPT_LN_BOBYQA},
                                          {"crs2", NLOPT_GN_CRS2_LM},           {"isres", NLOPT_GN_ISRES},
                                          {"direct", NLOPT_GN_DIRECT_L},        {"esch", NLOPT_GN_ESCH}};

struct CloseOptimizer {
  void operator()(nlopt_opt optimizer) const { nlopt_destroy(optimizer); }
};
using Optimizer = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, CloseOptimizer>;

/// What NLopt calls for every variant.
struct SearchCall {
  const Study& study;
  std::size_t unit = 0;
  const std::atomic<bool>& cancelled;
  nlopt_opt optimizer = nullptr;
  std::vector<ResultRow> rows;
};

double costOf(const ResultRow& row) {
  const auto* objective = std::get_if<double>(&row.objective);
  return (objective != nullptr ? *objective : kNoAnswer) + kPenalty * row.violation;
}

double evaluateShares(unsigned count, const double* shares, double* /*gradient*/, void* data) {
  auto& call = *static_cast<SearchCall*>(data);
  if (call.cancelled || call.rows.size() >= call.study.space().variantsPerUnit()) {
    nlopt_force_stop(call.optimizer);
    return kNoAnswer;
  }
  const std::vector<Value> values = call.study.space().searchValues(call.unit, {shares, shares + count});
  const auto number = static_cast<std::int64_t>(call.unit * call.study.space().variantsPerUnit() + call.rows.size());
  call.rows.push_back(call.study.evaluate(number, values));
  return costOf(call.rows.back());
}

}  // namespace

std::vector<ResultRow> Study::search(std::size_t unit, const std::atomic<bool>& cancelled) const {
  const SearchSettings& settings = document().search;
  const auto* named = std::find_if(std::begin(kAlgorithms), std::end(kAlgorithms),
                                   [&](const NamedAlgorithm& one) { return settings.method == one.name; });
  HAPTICELL_DEMAND(named != std::end(kAlgorithms));
  const auto dimensions = static_cast<unsigned>(space_.searched().size());
  const Optimizer optimizer(nlopt_create(named->algorithm, dimensions));
  SearchCall call{*this, unit, cancelled, optimizer.get(), {}};
  nlopt_set_min_objective(optimizer.get(), evaluateShares, &call);
  nlopt_set_lower_bounds1(optimizer.get(), 0.0);
  nlopt_set_upper_bounds1(optimizer.get(), 1.0);
  nlopt_set_maxeval(optimizer.get(), static_cast<int>(settings.evaluations));
  nlopt_set_xtol_abs1(optimizer.get(), settings.tolerance);
  nlopt_set_initial_step1(optimizer.get(), kFirstStep);
  // NLopt's random numbers are a thread's own; the search stays in this thread.
  nlopt_srand(static_cast<unsigned long>(document().seed * 1'000'003U + unit));
  std::vector<double> shares = space_.searchStart(unit);
  double least = 0.0;
  nlopt_optimize(optimizer.get(), shares.data(), &least);
  if (cancelled) return {};
  return std::move(call.rows);
}

}  // namespace hapticell::studies
