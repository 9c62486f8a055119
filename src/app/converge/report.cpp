// The page's plots, tables and sentences.
#include "app/converge/report.h"

#include <fmt/format.h>

#include "app/converge/sentences.h"
#include "report/assets.h"
#include "umbral_version.h"

namespace umbral {
namespace {

PlotPoint plotted(const ConvergencePoint& p, bool against_seconds) {
  const LogEstimate error = p.error();
  const Interval errors = error.interval(converge_confidence);
  const std::string text = fmt::format("{:g} spp, {}: {}", p.samples, seconds_text(p.seconds.value()),
                                       percent_with_interval(error));
  if (against_seconds)
    return {p.seconds.value(), error.value(), p.seconds.interval(converge_confidence), errors, text};
  return {p.samples, error.value(), {p.samples, p.samples}, errors, text};
}

Plot plot_of(const ConvergeReport& report, bool against_seconds) {
  Plot plot;
  plot.y = {"RMS error of a pixel, relative to the mean", PlotAxis::Ticks::decades, true};
  for (const ConvergeCurve& curve : report.result.curves) {
    PlotSeries series{curve.name, {}};
    for (const ConvergencePoint& p : curve.points) series.points.push_back(plotted(p, against_seconds));
    plot.series.push_back(series);
  }
  // Error falls with half the power of variance.
  plot.guides = {{-0.5, "variance slope −1"}};
  return plot;
}

const char* class_of(Finding finding) {
  switch (finding) {
    case Finding::holds:
      return "good";
    case Finding::fails:
      return "bad";
    case Finding::undecided:
      break;
  }
  return "unsure";
}

const char* word_of(Finding finding) {
  switch (finding) {
    case Finding::holds:
      return "holds";
    case Finding::fails:
      return "fails";
    case Finding::undecided:
      break;
  }
  return "undecided";
}

std::string list_item(const std::string& text) { return "<li>" + html_text(text) + "</li>\n"; }

std::string findings_html(const ConvergeReport& report) {
  const Findings& findings = report.findings;
  std::string text;
  for (const Against& against : findings.against)
    text += list_item(speed_sentence(against, report.result.curves[0].name));
  for (const std::string& sentence : findings.not_compared) text += list_item(sentence);
  for (const Equality& equality : findings.equalities) text += list_item(equality_sentence(equality));
  if (!text.empty()) text = "<h2>Findings</h2>\n<ul id=\"findings\">\n" + text + "</ul>\n";
  if (findings.checks.empty()) return text;
  text +=
      "<h2>Expectations</h2>\n<div class=\"scroll\"><table id=\"checks\"><tr><th>variant</th>"
      "<th class=\"text\">expectation</th><th class=\"text\">finding</th><th "
      "class=\"text\">numbers</th></tr>\n";
  for (const Check& check : findings.checks)
    text += fmt::format(
        "<tr><td>{}</td><td class=\"text\">{}</td><td class=\"text {}\">{}</td><td "
        "class=\"text wrap\">{}</td></tr>\n",
        html_text(check.variant), check.name, class_of(check.finding), word_of(check.finding),
        html_text(check.text));
  return text + "</table></div>\n";
}

std::string curve_html(const ConvergeReport& report, std::size_t i) {
  const ConvergeCurve& curve = report.result.curves[i];
  const std::optional<PowerLaw>& law = report.findings.slopes[i];
  std::string text = fmt::format("<h2>{}</h2>\n<p><code>{}</code>, {}</p>\n", html_text(curve.name),
                                 html_text(curve.call), html_text(curve.sampler));
  for (const std::string& note : curve.bias_notes)
    text += "<p class=\"unsure\">biased: " + html_text(note) + "</p>";
  if (curve.rejected > 0)
    text += fmt::format("<p class=\"bad\">{} samples were not finite or negative; they count as 0</p>\n",
                        curve.rejected);
  if (law)
    text += fmt::format("<p>{} of log variance against log samples{}</p>\n", slope_text(*law),
                        law->bent() ? "; not a straight line: " + local_slopes_text(curve) : "");
  if (report.expectations.target_error > 0)
    text +=
        "<p>" +
        html_text(effort_sentence(curve, report.findings.efforts[i], law, report.expectations.target_error)) +
        "</p>\n";
  text +=
      "<div class=\"scroll\"><table><tr><th>spp</th><th>RMS error</th><th>wall s</th><th>CPU s</th>"
      "<th>efficiency, 1/s</th></tr>\n";
  for (std::size_t k = 0; k < curve.points.size(); ++k) {
    const ConvergencePoint& p = curve.points[k];
    text += fmt::format("<tr><td>{:g}</td><td>{}</td><td>{:.4g}</td><td>{:.4g}</td><td>{}</td></tr>\n",
                        p.samples, percent_with_interval(p.error()), curve.wall_seconds[k],
                        curve.cpu_seconds[k], with_interval(p.efficiency()));
  }
  return text + "</table></div>\n";
}

constexpr const char* explanation =
    "Error is the root of the variance of a pixel, mean over pixels and channels, in units of the image's "
    "mean: that "
    "of one render, from the spread of independent ones. Intervals and bars are of 95 %. The slope is that "
    "of the "
    "variance: −1 for Monte Carlo, down to −3 for scrambled nets on smooth integrands. Efficiency is "
    "1/(variance × "
    "seconds). A click on an entry of a legend hides its curve.";

}  // namespace

Plot samples_plot(const ConvergeReport& report) {
  Plot plot = plot_of(report, false);
  plot.title = "Error against samples";
  plot.x = {"samples per pixel", PlotAxis::Ticks::powers_of_two};
  return plot;
}

Plot seconds_plot(const ConvergeReport& report) {
  Plot plot = plot_of(report, true);
  plot.title = "Error against seconds";
  plot.x = {report.settings.clock == Clock::wall ? "seconds" : "seconds of all threads together"};
  return plot;
}

Page page_of(const ConvergeReport& report) {
  Page page;
  page.title = "Convergence of " + report.scene;
  page.body =
      fmt::format("<h1>{}</h1>\n<p class=\"muted\">{}; umbral {}</p>\n<div class=\"plots\">\n{}{}</div>\n",
                  html_text(page.title), html_text(headline(report)), html_text(version),
                  svg(samples_plot(report)), svg(seconds_plot(report)));
  page.body += findings_html(report);
  for (std::size_t i = 0; i < report.result.curves.size(); ++i) page.body += curve_html(report, i);
  page.body += std::string("<h2>How to read it</h2>\n<p>") + explanation + "</p>\n";
  page.data = json_text(report);
  page.styles = {assets::plot_css};
  page.scripts = {assets::plot_js};
  return page;
}

JunitSuite suite_of(const ConvergeReport& report) {
  JunitSuite suite{
      "umbral converge " + report.scene, {{"umbral", version}, {"measured", headline(report)}}, {}};
  for (const Check& check : report.findings.checks)
    suite.cases.push_back({check.variant, check.name,
                           check.finding == Finding::holds   ? JunitStatus::passed
                           : check.finding == Finding::fails ? JunitStatus::failed
                                                             : JunitStatus::error,
                           check.text, 0});
  for (std::size_t i = 0; i < report.result.curves.size() && report.findings.checks.empty(); ++i) {
    const std::optional<PowerLaw>& law = report.findings.slopes[i];
    suite.cases.push_back({report.result.curves[i].name, "measured",
                           law ? JunitStatus::passed : JunitStatus::error,
                           law ? slope_text(*law) : "there are fewer than three points", 0});
  }
  if (!suite.cases.empty()) suite.cases.front().seconds = report.result.seconds;
  return suite;
}

}  // namespace umbral
