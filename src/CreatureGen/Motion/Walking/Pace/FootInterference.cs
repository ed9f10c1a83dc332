using System;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Steps;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Pace;

/// <summary>
/// How far feet can go in a stance before one runs into the foot ahead of it on its side: a shorter way the longer or broader the feet and the nearer they are to each other, and
/// the later the one ahead leaves its place before the one behind comes to it.
/// </summary>
internal static class FootInterference
{
    private const int Samples = 48;

    /// <summary>Part of the length of two feet below the body by which they keep apart: one of them is in the air, with its toes down.</summary>
    private const float FootFraction = 0.8f;

    /// <summary>Part of the breadths of two legs out to the side by which they keep apart.</summary>
    private const float BreadthFraction = 0.9f;

    /// <summary>Room that legs out to the side have in any case, leg lengths: shorter steps would be a patter.</summary>
    private const float MinRoom = 0.3f;

    /// <summary>The longest stance, metres; without end for bodies whose feet go past each other side by side, and in gaits that tuck them up.</summary>
    public static float LongestStance(LeggedBody body, Gait gait)
    {
        float min = float.MaxValue;
        if (body.IsBiped || gait.Tuck > 0f)
        {
            return min;
        }

        float duty = gait.Duty.At(gait.Comfortable);
        for (int i = 0; i < body.Legs.Length; i++)
        {
            for (int k = 0; k < body.Legs.Length; k++)
            {
                LegRig hind = body.Legs[i];
                LegRig fore = body.Legs[k];
                if (fore.Row == hind.Row + 1 && hind.Side == fore.Side && (hind.Lateral || fore.Lateral || InOneTrack(hind, fore)))
                {
                    float room = Room(hind, fore, body.GoingHomes[k].Z - body.GoingHomes[i].Z);
                    min = Math.Min(min, room / Nearest(gait, hind, fore, body.Rows, duty));
                }
            }
        }

        return min;
    }

    private static float Room(LegRig hind, LegRig fore, float distance) => hind.Lateral || fore.Lateral
        ? Math.Max(distance - KneeAhead(hind) - (BreadthFraction * (hind.Breadth + fore.Breadth)), MinRoom * hind.Length)
        : Math.Max(distance - (FootFraction * (hind.Toe + fore.Heel)), 0f);

    /// <summary>The knees of frogs' hind legs are beside their fore feet, ahead of their own.</summary>
    private static float KneeAhead(LegRig hind) =>
        hind.Traits.Kind.Step.KneesAhead ? Math.Max(hind.HipRest.Z + hind.Thigh.Z - hind.Home.Z, 0f) : 0f;

    private static bool InOneTrack(LegRig hind, LegRig fore) => Math.Abs(hind.Home.X - fore.Home.X) < hind.HalfWidth + fore.HalfWidth;

    /// <summary>The most that a foot gains on the one ahead of it, against where they are at rest, stance lengths.</summary>
    private static float Nearest(Gait gait, LegRig hind, LegRig fore, int rows, float duty)
    {
        float hindLag = gait.Phases.Lag(hind.Row, rows, hind.Side, duty);
        float foreLag = gait.Phases.Lag(fore.Row, rows, fore.Side, duty);
        float bias = rows == 2 ? gait.HindBias - gait.ForeBias : 0f;
        float max = 0.1f;
        for (int i = 0; i < Samples; i++)
        {
            float phase = i / (float)Samples;
            max = Math.Max(max, Along(StepPhase.Place(phase, hindLag), duty) - Along(StepPhase.Place(phase, foreLag), duty) + bias);
        }

        return max;
    }

    /// <summary>Where a foot is ahead of the middle of its stance under a body that goes on steadily, stance lengths.</summary>
    private static float Along(float p, float duty)
    {
        float still = 0.5f - (p / duty);
        return p < duty ? still : still + (StepPhase.Along(StepPhase.Swing(p, duty)) / duty);
    }
}
