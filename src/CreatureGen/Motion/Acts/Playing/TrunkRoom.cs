using System;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>How far a trunk goes each way without lifting a planted foot: what acts and moods ask beyond is not done; and where its legs fold. Immutable once it is found.</summary>
internal sealed class TrunkRoom
{
    private readonly (ActChannel Channel, float Min, float Max)[] ways;

    public TrunkRoom((ActChannel Channel, float Min, float Max)[] ways, FoldedLegs legs)
    {
        this.ways = ways;
        Legs = legs;
    }

    /// <summary>Where its legs fold.</summary>
    public FoldedLegs Legs { get; }

    /// <summary>All that is asked of a trunk, with legs that fold in these places.</summary>
    public static TrunkRoom Any(FoldedLegs legs) => new(Array.Empty<(ActChannel, float, float)>(), legs);

    /// <summary>Brings values into it.</summary>
    public void Clamp(float[] values)
    {
        foreach ((ActChannel channel, float min, float max) in ways)
        {
            float value = values[(int)channel];
            values[(int)channel] = value < min ? min : value > max ? max : value;
        }
    }
}
