// The functions that --wrap calls in place of Embree's own.
#include "ray_count.h"

#include <atomic>

#include "scene/accel_embree.h"

namespace {

std::atomic<bool> counting{false};
std::atomic<std::uint64_t> rays{0};

void count_one() {
  if (counting.load(std::memory_order_relaxed)) rays.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

namespace umbral::bench {

void count_rays(bool on) {
  if (on) rays = 0;
  counting = on;
}

std::uint64_t rays_counted() { return rays; }

}  // namespace umbral::bench

extern "C" {
#if UMBRAL_EMBREE_MAJOR >= 4
void __real_rtcIntersect1(RTCScene, RTCRayHit*, RTCIntersectArguments*);
void __real_rtcOccluded1(RTCScene, RTCRay*, RTCOccludedArguments*);
void __wrap_rtcIntersect1(RTCScene scene, RTCRayHit* ray, RTCIntersectArguments* arguments) {
  count_one();
  __real_rtcIntersect1(scene, ray, arguments);
}
void __wrap_rtcOccluded1(RTCScene scene, RTCRay* ray, RTCOccludedArguments* arguments) {
  count_one();
  __real_rtcOccluded1(scene, ray, arguments);
}
#else
void __real_rtcIntersect1(RTCScene, RTCIntersectContext*, RTCRayHit*);
void __real_rtcOccluded1(RTCScene, RTCIntersectContext*, RTCRay*);
void __wrap_rtcIntersect1(RTCScene scene, RTCIntersectContext* context, RTCRayHit* ray) {
  count_one();
  __real_rtcIntersect1(scene, context, ray);
}
void __wrap_rtcOccluded1(RTCScene scene, RTCIntersectContext* context, RTCRay* ray) {
  count_one();
  __real_rtcOccluded1(scene, context, ray);
}
#endif
}
