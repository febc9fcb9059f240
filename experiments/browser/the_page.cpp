// SPDX-License-Identifier: MIT
#include "experiments/browser/the_page.hpp"

#include <emscripten.h>

#include <cstdlib>

// Their bodies are JavaScript, which has no types to name.
EM_ASYNC_JS(double, page_next_frame, (), { return await Module.page.nextFrame(); });
EM_ASYNC_JS(char*, page_ask, (const char* page),
            { return allocateUTF8(await Module.page.ask(UTF8ToString(page))); });
EM_ASYNC_JS(void, page_await_saved, (const char* standing),
            { await Module.page.awaitSaved(UTF8ToString(standing)); });
EM_JS(void, page_hand_over, (const char* line), { Module.page.handOver(UTF8ToString(line)); });
EM_JS(char*, page_take_events, (), { return allocateUTF8(Module.page.takeEvents()); });
EM_JS(void, page_show_progress, (const char* words),
      { Module.page.showProgress(UTF8ToString(words)); });
EM_JS(void, page_show_target, (int on, double x, double y), { Module.page.showTarget(on, x, y); });
EM_JS(void, page_show_picture, (int pointer), { Module.page.showPicture(pointer); });
EM_JS(void, page_tell, (const char* sentence), { Module.page.tell(UTF8ToString(sentence)); });

namespace impetus::inline browser {
namespace {

/// The text of a JavaScript string that was put into our memory, which is given back.
std::string taken(char* text) {
  std::string copy = text;
  std::free(text);
  return copy;
}

}  // namespace

std::int64_t next_frame() { return static_cast<std::int64_t>(page_next_frame() * 1e6); }

nlohmann::json ask_of_participant(const nlohmann::json& page) {
  return nlohmann::json::parse(taken(page_ask(page.dump().c_str())));
}

void await_kept(const nlohmann::json& standing) { page_await_saved(standing.dump().c_str()); }
void hand_over(const std::string& line) { page_hand_over(line.c_str()); }
nlohmann::json take_events() { return nlohmann::json::parse(taken(page_take_events())); }
void show_progress(const nlohmann::json& progress) { page_show_progress(progress.dump().c_str()); }
void show_target(bool on, double x_px, double y_px) { page_show_target(on ? 1 : 0, x_px, y_px); }
void show_picture(bool with_pointer) { page_show_picture(with_pointer ? 1 : 0); }
void tell(const std::string& sentence) { page_tell(sentence.c_str()); }

}  // namespace impetus::inline browser
