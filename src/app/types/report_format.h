#pragma once

namespace skydrop::app {

// How the report of `skydrop accuracy` is written.
enum class ReportFormat {
  markdown,  // a section and a table a study, its Pareto-optimal rows marked
  json,      // schema 1: studies[] {title, method, machine, metrics[] {name, unit}, cost {unit, clock},
             // rows[] {label, errors[], cost, paretoOptimal, note}}; a number that is not finite is null
  csv        // RFC 4180, a line a row and metric: study, label, metric, unit, error, cost, costUnit, clock,
             // paretoOptimal, note
};

}  // namespace skydrop::app
