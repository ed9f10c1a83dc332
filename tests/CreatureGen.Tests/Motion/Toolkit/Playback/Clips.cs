using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Tests.Motion.Toolkit.Playback;

/// <summary>Small clips of a skeleton of two joints, a root and an arm.</summary>
internal static class Clips
{
    public static Skeleton Skeleton { get; } = Skeleton.Build([
        new JointPlacement("Root", -1, Quaternion.Identity, Vector3.Zero),
        new JointPlacement("Arm", 0, Quaternion.Identity, Vector3.UnitY),
    ]);

    /// <summary>The arm turns about X from one angle to another and, in a loop, back.</summary>
    public static KeyedClip Swing(string name, float duration, float from, float to, ClipEnd end = ClipEnd.Loops, float speed = 0f, params ClipEvent[] events)
    {
        float[] times = end == ClipEnd.Loops ? [0f, duration / 2, duration] : [0f, duration];
        Quaternion[] turns = end == ClipEnd.Loops ? [About(from), About(to), About(from)] : [About(from), About(to)];
        return new KeyedClip(
            name, end, duration, speed,
            [KeyTrack.OfRotations([0f], [Quaternion.Identity], KeyInterpolation.Step), KeyTrack.OfRotations(times, turns, KeyInterpolation.Linear)],
            [KeyTrack.OfPositions([0f], [Vector3.Zero], KeyInterpolation.Step), KeyTrack.OfPositions([0f], [Vector3.UnitY], KeyInterpolation.Step)],
            events);
    }

    /// <summary>The root goes ahead and turns left while the clip plays.</summary>
    public static KeyedClip Travel(float duration, float metres, float turn)
    {
        const int Keys = 33;
        float[] times = new float[Keys];
        var turns = new Quaternion[Keys];
        var places = new Vector3[Keys];
        for (int i = 0; i < Keys; i++)
        {
            float part = i / (float)(Keys - 1);
            times[i] = part * duration;
            turns[i] = Quaternion.CreateFromAxisAngle(Vector3.UnitY, part * turn);

            // An arc: as long as metres, tangent to the heading.
            places[i] = turn == 0f ? new Vector3(0f, 0.5f, part * metres) : new Vector3(metres / turn * (1f - MathF.Cos(part * turn)), 0.5f, metres / turn * MathF.Sin(part * turn));
        }

        return new KeyedClip(
            "Travel", ClipEnd.Loops, duration, 0f,
            [KeyTrack.OfRotations(times, turns, KeyInterpolation.Linear), KeyTrack.OfRotations([0f], [Quaternion.Identity], KeyInterpolation.Step)],
            [KeyTrack.OfPositions(times, places, KeyInterpolation.Linear), KeyTrack.OfPositions([0f], [Vector3.UnitY], KeyInterpolation.Step)],
            []);
    }

    public static float ArmAngle(Quaternion[] rotations) => 2f * MathF.Atan2(rotations[1].X, rotations[1].W);

    public static List<string> Names(ClipPassage passage)
    {
        var names = new List<string>();
        foreach (ClipEvent one in passage)
        {
            names.Add(one.Name);
        }

        return names;
    }

    private static Quaternion About(float angle) => Quaternion.CreateFromAxisAngle(Vector3.UnitX, angle);
}
