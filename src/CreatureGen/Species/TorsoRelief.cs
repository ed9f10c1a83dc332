using CreatureGen.Blueprints;

namespace CreatureGen.Species;

/// <summary>Muscle and bone under the skin of a torso: shoulder blades, haunches and flanks, as swellings and hollows.</summary>
internal static class TorsoRelief
{
    /// <summary>Of mammals.</summary>
    public static readonly HeadBump[] Mammal =
    {
        new(Ring: 25.2, Segment: 4.6, RingSpread: 1.7, SegmentSpread: 1.7, Amount: 0.075),   // shoulder blade
        new(Ring: 28.4, Segment: 5.0, RingSpread: 1.5, SegmentSpread: 2.4, Amount: -0.05),   // behind it
        new(Ring: 40.6, Segment: 5.6, RingSpread: 2.2, SegmentSpread: 2.2, Amount: 0.06),    // haunch
        new(Ring: 37.2, Segment: 8.6, RingSpread: 2.0, SegmentSpread: 2.2, Amount: -0.06),   // flank
    };

    /// <summary>Of lizards and dinosaurs.</summary>
    public static readonly HeadBump[] Reptile =
    {
        new(Ring: 25.0, Segment: 5.2, RingSpread: 1.7, SegmentSpread: 2.0, Amount: 0.05),
        new(Ring: 40.6, Segment: 5.8, RingSpread: 2.0, SegmentSpread: 2.2, Amount: 0.05),
        new(Ring: 37.0, Segment: 8.0, RingSpread: 2.2, SegmentSpread: 2.4, Amount: -0.04),
    };
}
