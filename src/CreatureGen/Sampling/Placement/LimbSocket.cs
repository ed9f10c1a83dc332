using CreatureGen.Anatomy;

namespace CreatureGen.Sampling.Placement;

/// <summary>An anatomical place that may carry a pair of legs or arms.</summary>
/// <param name="Ring">Ring of its centre.</param>
/// <param name="Segment">Segment of its centre on the left flank: 8 at the side, 16 at the belly.</param>
/// <param name="Archetype">The built form of the limb that grows here.</param>
/// <param name="Girth">Radius of the limb's root relative to half the body's thickness here.</param>
/// <param name="Reach">How far out the foot of a splayed leg stands, or the unit of its length when it hangs, relative to the body's length; 0 for limbs under the body.</param>
/// <param name="Azimuth">Turn of a splayed leg towards the front, radians.</param>
/// <param name="Bounds">How small and large its socket may be.</param>
internal readonly record struct LimbSocket(int Ring, double Segment, LimbArchetype Archetype, double Girth, double Reach, double Azimuth, SocketBounds Bounds);
