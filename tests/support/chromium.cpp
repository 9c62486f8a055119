// A copy of the page with a script at either end, of which Chromium dumps what is left.
#include "support/chromium.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "support/command.h"
#include "support/contents.h"
#include "support/paths.h"

namespace umbral::test {
namespace {

namespace fs = std::filesystem;

// Notes requests and errors from before the page's first script.
constexpr const char* recorder = R"(<script>
const requests = [], failures = [];
document.addEventListener('securitypolicyviolation', event => requests.push(event.blockedURI));
addEventListener('error', event => { if (event.message) failures.push(event.message); });
addEventListener('unhandledrejection', event => failures.push(String(event.reason)));
const next_frame = () => new Promise(done => setTimeout(done, 20));
</script>
)";

std::string runner(const std::string& script) {
  return R"(<script>
addEventListener('load', async () => {
  let result;
  try {
    for (const entry of performance.getEntriesByType('resource')) requests.push(entry.name);
    result = await (async () => {)" +
         script + R"(})();
  } catch (error) { result = {error: String(error)}; }
  const element = document.createElement('pre');
  element.id = 'test-result';
  element.textContent = JSON.stringify(result ?? null);
  document.documentElement.append(element);
});
</script>
)";
}

void insert_before(std::string& text, const std::string& place, const std::string& piece) {
  const std::size_t at = text.rfind(place);
  if (at == std::string::npos) throw std::runtime_error("the page has no " + place);
  text.insert(at, piece);
}

std::string without_entities(std::string text) {
  for (const auto& [entity, character] :
       {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&nbsp;", "\u00a0"}, {"&amp;", "&"}})
    for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; ++at)
      text.replace(at, std::string(entity).size(), character);
  return text;
}

}  // namespace

std::optional<std::string> chromium() {
  if (const char* chosen = std::getenv("UMBRAL_CHROMIUM")) return chosen;
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
    if (run_command(std::string("command -v ") + name).exit_code == 0) return name;
  return std::nullopt;
}

nlohmann::json run_in_page(const fs::path& page, const std::string& script) {
  const TemporaryDirectory directory;
  const fs::path copy = directory.path() / "page.html";
  std::string text = contents(page);
  insert_before(text, "<title>", recorder);
  insert_before(text, "</body>", runner(script));
  std::ofstream(copy, std::ios::binary) << text;
  const CommandResult result = run_command(
      chromium().value() +
      " --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking --disable-sync"
      " --window-size=1280,900 --virtual-time-budget=20000 --user-data-dir='" +
      (directory.path() / "profile").string() + "' --dump-dom 'file://" + copy.string() + "' 2>/dev/null");
  const std::string& dump = result.text;
  const std::string opening = "<pre id=\"test-result\">";
  const std::size_t begin = dump.rfind(opening);
  if (begin == std::string::npos) throw std::runtime_error("the page never finished: " + dump);
  const std::size_t end = dump.find("</pre>", begin);
  return nlohmann::json::parse(
      without_entities(dump.substr(begin + opening.size(), end - begin - opening.size())));
}

}  // namespace umbral::test
