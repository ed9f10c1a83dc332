using System;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>How far a trunk goes each way without lifting a planted foot: what acts and moods ask beyond is not done. Immutable.</summary>
internal sealed class TrunkRoom
{
    private readonly (ActChannel Channel, float Least, float Most)[] ways;

    public TrunkRoom((ActChannel Channel, float Least, float Most)[] ways) => this.ways = ways;

    /// <summary>All that is asked.</summary>
    public static TrunkRoom Any { get; } = new(Array.Empty<(ActChannel, float, float)>());

    /// <summary>Brings values into it.</summary>
    public void Clamp(float[] values)
    {
        foreach ((ActChannel channel, float least, float most) in ways)
        {
            float value = values[(int)channel];
            values[(int)channel] = value < least ? least : value > most ? most : value;
        }
    }
}
