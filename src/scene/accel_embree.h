// The one place that knows which Embree this is: 3.13 (Debian 12) and 4.x (Debian 13) differ in a few names.
#pragma once

#if UMBRAL_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace umbral::embree {

#if UMBRAL_EMBREE_MAJOR >= 4

inline void intersect(RTCScene scene, RTCRayHit& ray_hit) { rtcIntersect1(scene, &ray_hit); }
inline void occluded(RTCScene scene, RTCRay& ray) { rtcOccluded1(scene, &ray); }

#else

inline void intersect(RTCScene scene, RTCRayHit& ray_hit) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &ray_hit);
}
inline void occluded(RTCScene scene, RTCRay& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &ray);
}

#endif

}  // namespace umbral::embree
