using System.Collections.Generic;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Motion.Acts.Playing;

namespace CreatureGen.Motion.Acts.Rehearsing;

/// <summary>Finds how far a trunk goes each way over planted feet.</summary>
internal static class RoomSearch
{
    /// <summary>How far a planted foot may be off, parts of its leg, and how deep the skin may be, parts of the body's length.</summary>
    private const float MaxSlip = 0.004f;
    private const float MaxSunk = 0.01f;

    private const int Halvings = 6;

    // Farthest that is tried, and whether the other way is the same.
    private static readonly (ActChannel Channel, float Min, float Max)[] farthest =
    {
        (ActChannel.Ahead, -0.5f, 0.5f),
        (ActChannel.Aside, 0f, 0.3f),
        (ActChannel.Yaw, 0f, 0.5f),
        (ActChannel.Roll, 0f, 0.3f),
        (ActChannel.BackPitch, -0.6f, 0.6f),
        (ActChannel.BackSide, 0f, 0.6f),
        (ActChannel.BackTwist, 0f, 0.5f),
    };

    /// <summary>The room of a body that legs carry, any room for others: nothing while it is sought, one end of a way a step, then the room.</summary>
    /// <param name="body">Whose.</param>
    /// <param name="stage">Where it is tried.</param>
    /// <param name="legs">Where its legs fold.</param>
    public static IEnumerable<TrunkRoom?> Steps(ActBody body, ActStage stage, FoldedLegs legs)
    {
        if (body.Legs == null)
        {
            yield return TrunkRoom.Any(legs);
            yield break;
        }

        var ways = new List<(ActChannel, float, float)>();
        foreach ((ActChannel channel, float min, float max) in farthest)
        {
            float to = End(stage, channel, max);
            yield return null;

            // A way without a least is the same to both sides.
            ways.Add((channel, min == 0f ? -to : End(stage, channel, min), to));
            yield return null;
        }

        yield return new TrunkRoom(ways.ToArray(), legs);
    }

    private static float End(ActStage stage, ActChannel channel, float farthest)
    {
        float good = 0f;
        float bad = farthest;
        for (int i = 0; i < Halvings; i++)
        {
            float at = i == 0 ? farthest : 0.5f * (good + bad);
            stage.Show(channel, at);
            bool fits = stage.Slip() <= MaxSlip && stage.Sunk() <= MaxSunk;
            good = fits ? at : good;
            bad = fits ? bad : at;
            if (good == farthest)
            {
                break;
            }
        }

        return good;
    }
}
