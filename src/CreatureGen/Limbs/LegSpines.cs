using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Limbs;

/// <summary>The two rows of spines that a grasping leg shuts on what it holds: without them the arm of a mantis is a sausage.</summary>
internal static class LegSpines
{
    // Radius of a spine in that of the leg, its length in its own radii, and how far it leans to the leg's end.
    private const float Radius = 0.17f;
    private const float Length = 5f;
    private const float Lean = 0.45f;

    /// <summary>How deep it stands in the leg, in that one's radii.</summary>
    private const float Depth = 0.8f;

    /// <summary>Adds the spines of a leg that folds between its knee and its ankle.</summary>
    /// <param name="form">Its form, two sections to a row.</param>
    /// <param name="grown">How it grew.</param>
    /// <param name="tips">Where they go.</param>
    public static void Add(LegForm form, SweepResult grown, List<DigitTip> tips)
    {
        int knee = 2 * form.KneeRow;
        int ankle = 2 * form.AnkleRow;
        int end = 2 * form.BallRow;
        for (int q = knee + 1; q < end; q++)
        {
            if (q >= ankle - 1 && q <= ankle + 1)
            {
                continue;
            }

            SweepFrame frame = grown.Frames[q];
            Vector3 other = grown.Frames[q < ankle ? (ankle + end) / 2 : (knee + ankle) / 2].Centre;
            Vector3 inward = frame.Fore * (Vec.Dot(frame.Fore, other - frame.Centre) < 0f ? -1f : 1f);
            int vertex = grown.End[0] - ((grown.Frames.Length - 1 - q) * grown.End.Length);
            tips.Add(new DigitTip(DigitTipKind.Claw, frame.Centre + (inward * (Depth * frame.ForeRadius)), Vec.Normalize(inward + (frame.Tangent * Lean)), Radius * frame.ForeRadius, Length, vertex));
        }
    }
}
