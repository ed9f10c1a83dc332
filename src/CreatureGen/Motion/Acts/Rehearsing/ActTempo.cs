using System;
using CreatureGen.Motion.Acts.Bodies;

namespace CreatureGen.Motion.Acts.Rehearsing;

/// <summary>How slowly a body does an act, beside what follows from the length of its legs.</summary>
internal static class ActTempo
{
    /// <summary>Kilograms above which getting down and up is slower, and how much.</summary>
    private const float HeavyMass = 200f;
    private const float HeavyPosture = 1.6f;

    /// <summary>A factor on the act's time.</summary>
    public static float Of(Act act, ActBody body)
    {
        float heavy = Math.Min(Math.Max((body.Subject.Mass.Mass / HeavyMass) - 0.5f, 0f), 1f);
        return act.Kind == ActKind.Posture ? 1f + ((HeavyPosture - 1f) * heavy) : 1f;
    }
}
