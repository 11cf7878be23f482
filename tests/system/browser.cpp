#include <nlohmann/json.hpp>

#include "system/browser.h"

#include "system/process.h"
#include "system/source_files.h"

namespace lsos::test {

namespace {

// Events like those of a mouse. The axes of a plot begin 64 pixels from its left edge and end 10
// pixels before its right edge.
const std::string tools = R"js(
const rest = () => new Promise(done => setTimeout(done, 120));
const at = (element, share) => {
  const box = element.getBoundingClientRect();
  return {clientX: box.left + 64 + share * (box.width - 74), clientY: box.top + 40, bubbles: true,
          button: 0, pointerId: 1};
};
const send = (element, type, share) =>
  element.dispatchEvent(new PointerEvent(type, at(element, share)));
const move = async (element, share) => { send(element, 'pointermove', share); await rest(); };
const drag = async (element, from, to) => {
  send(element, 'pointerdown', from);
  send(element, 'pointermove', (from + to) / 2);
  send(element, 'pointermove', to);
  send(element, 'pointerup', to);
  await rest();
};
const twice = async element => {
  element.dispatchEvent(new MouseEvent('dblclick', {bubbles: true}));
  await rest();
};
const click = async element => { element.click(); await rest(); };
const text = selector => document.querySelector(selector).textContent;
const plot = key => document.querySelector(`#plot-${key} .surface`);
)js";

}  // namespace

std::string browser() {
  for (const char* name : {"chromium-headless-shell", "chromium", "google-chrome"}) {
    if (run_command({"which", name}).exit_code == 0) return name;
  }
  return {};
}

nlohmann::json in_browser(const TempFolder& folder, const std::string& page_file,
                          const std::string& steps) {
  std::string page = read_text(page_file);
  const std::size_t end = page.rfind("</body>");
  if (end == std::string::npos) return {{"error", "no page"}};
  page.insert(end, "<script>(async () => {" + tools + "const steps = async () => {" + steps +
                       R"js(};
const answer = await steps().catch(error => ({error: String(error)}));
const mark = document.createElement('pre');
mark.id = 'answer';
mark.textContent = btoa(unescape(encodeURIComponent(JSON.stringify(answer))));
document.body.append(mark);
})();</script>)js");
  // With --dump-dom no frames are drawn, so that animation frames need a timer instead.
  const std::string head = "<head>";
  page.insert(page.find(head) + head.size(),
              "<script>window.requestAnimationFrame = f => setTimeout(f, 10);</script>");
  const std::string copy = folder.write("tested.html", page);
  const Outcome outcome = run_command({browser(), "--headless", "--no-sandbox", "--disable-gpu",
                                       "--window-size=1280,5000", "--virtual-time-budget=20000",
                                       "--dump-dom", "file://" + copy});
  const std::string key = "<pre id=\"answer\">";
  const std::size_t from = outcome.out.rfind(key);
  if (from == std::string::npos) return {{"error", "no answer: " + outcome.err}};
  const std::size_t begin = from + key.size();
  const std::string packed = outcome.out.substr(begin, outcome.out.find('<', begin) - begin);
  const std::string file = folder.write("answer.txt", packed);
  return nlohmann::json::parse(run_command({"base64", "-d", file}).out, nullptr, false);
}

}  // namespace lsos::test
