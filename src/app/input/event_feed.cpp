#include "app/input/event_feed.h"

namespace skydrop::app {
namespace {

using render::gl::WindowEvent;
using Kind = WindowEvent::Kind;

}  // namespace

void EventFeed::add(const WindowEvent& event, double pixelsPerUnit) {
  if (event.kind == Kind::resize) return;
  if (event.kind == Kind::key && event.repeated) {
    // The interface sees a repeated key go up and down again; it is no press for anybody else.
    if (!ImGuiInput::isEditingKey(event)) return;
    WindowEvent again = event;
    again.repeated = false;
    for (const bool pressed : {false, true}) {
      again.pressed = pressed;
      waiting_.push_back({again, false});
    }
    return;
  }
  Waiting next{event, true};
  if (event.kind == Kind::mouseMove || event.kind == Kind::mouseButton) {
    next.event.x *= pixelsPerUnit;
    next.event.y *= pixelsPerUnit;
  }
  waiting_.push_back(next);
}

void EventFeed::addForInterface(const WindowEvent& event) { waiting_.push_back({event, false}); }

// Without a menu nothing of the interface can be hit, and nothing is hidden from it.
bool EventFeed::isReady(const WindowEvent& event, bool open) const {
  if (framesSinceOpening_ < kFramesToSettle) return false;
  if (!open) return true;
  const bool needsFocus = event.kind == Kind::key && event.pressed;
  if (needsFocus && framesSinceFocus_ < kFramesToSettle) return false;
  return input_->canTake(event);
}

void EventFeed::handOver(const Waiting& next, const Readers& readers, bool open) {
  if (next.forFirst && readers.first && readers.first(next.event)) return;
  input_->take(next.event);
  if (open && ImGuiInput::movesFocus(next.event)) framesSinceFocus_ = 0;
}

void EventFeed::deliver(const Readers& readers) {
  for (int frames = 0; !waiting_.empty();) {
    const bool open = readers.interfaceOpen();
    if (open != wasOpen_) {
      wasOpen_ = open;
      framesSinceOpening_ = open ? 0 : kFramesToSettle;
    }
    if (!isReady(waiting_.front().event, open)) {
      if (frames++ == kMostFrames) return;
      readers.buildFrame();
      continue;
    }
    const Waiting next = waiting_.front();
    waiting_.pop_front();
    handOver(next, readers, open);
  }
}

void EventFeed::frameBuilt() {
  if (framesSinceOpening_ < kFramesToSettle) ++framesSinceOpening_;
  if (framesSinceFocus_ < kFramesToSettle) ++framesSinceFocus_;
  input_->frameBegan();
}

}  // namespace skydrop::app
