#include "accuracy/report_json.h"

#include "accuracy/report_text.h"

namespace skydrop::accuracy {
namespace {

using nlohmann::ordered_json;

constexpr int kReportSchema = 3;

ordered_json pointJson(const CaseResult& of, std::size_t index, const PictureText& picture) {
  const PointResult& point = of.points[index];
  ordered_json onFront = ordered_json::array(), bounds = ordered_json::array();
  bool isShown = !point.shipped.empty();
  for (std::size_t m = 0; m < of.metrics.size(); ++m) {
    onFront.push_back(isOnFront(of, m, index));
    isShown = isShown || onFront.back();
    const std::optional<double> bound = boundOf(of, m, point);
    bounds.push_back(bound ? ordered_json(*bound) : ordered_json());
  }
  ordered_json json = {{"label", point.label},
                       {"set", point.set},
                       {"shipped", point.shipped},
                       {"reference", point.reference},
                       {"errors", point.errors},
                       {"bounds", bounds},
                       {"ms",
                        {{"median", point.medianMs()},
                         {"least", point.leastMs()},
                         {"most", point.mostMs()},
                         {"repeats", point.ms}}},
                       {"onFront", onFront}};
  if (!point.picture.empty()) {
    json["picture"] = picture ? picture(point.picture, isShown) : point.picture;
    json["heat"] = picture ? picture(point.heat, isShown) : point.heat;
  }
  return json;
}

ordered_json caseJson(const CaseResult& of, const PictureText& picture) {
  ordered_json json = {{"study", of.study},   {"case", of.name},      {"title", of.title},
                       {"method", of.method}, {"timed", of.timed},    {"timeUnit", of.timeUnit},
                       {"clock", of.clock},   {"machine", of.machine}};
  json["metrics"] = json["points"] = json["references"] = json["doubts"] = json["orders"] =
      ordered_json::array();
  for (const MetricColumn& m : of.metrics)
    json["metrics"].push_back({{"name", m.name}, {"title", m.title}, {"unit", m.unit}, {"floor", m.floor}});
  for (std::size_t i = 0; i < of.points.size(); ++i) json["points"].push_back(pointJson(of, i, picture));
  for (const ReferenceResult& reference : of.references) {
    ordered_json one = {{"label", reference.label}, {"changes", reference.changes}};
    if (!reference.picture.empty())
      one["picture"] = picture ? picture(reference.picture, true) : reference.picture;
    json["references"].push_back(one);
  }
  for (const Doubt& doubt : doubts(of)) json["doubts"].push_back(doubtText(of, doubt));
  for (const ObservedOrder& order : observedOrders(of, 0))
    json["orders"].push_back({{"series", order.series}, {"path", of.order}, {"order", order.order}});
  if (!of.failure.empty()) json["failure"] = of.failure;
  return json;
}

}  // namespace

ordered_json reportJson(const Results& results, const PictureText& picture) {
  ordered_json json = {{"schema", kReportSchema},
                       {"program", results.program},
                       {"quick", results.quick},
                       {"cases", results.allCases},
                       {"studies", ordered_json::array()}};
  for (const CaseResult& of : results.cases) json["studies"].push_back(caseJson(of, picture));
  return json;
}

}  // namespace skydrop::accuracy
