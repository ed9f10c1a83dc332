using System;
using CreatureGen.Maths;

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

    /// <summary>Brings values into it, by as much as feet stand: legs that are folded under a body let it go where it likes.</summary>
    public void Clamp(float[] values)
    {
        float free = Scalar.Smooth(Math.Min(values[(int)ActChannel.ForeFold], values[(int)ActChannel.HindFold]));
        foreach ((ActChannel channel, float min, float max) in ways)
        {
            float value = values[(int)channel];
            values[(int)channel] = Scalar.Lerp(value < min ? min : value > max ? max : value, value, free);
        }
    }
}
