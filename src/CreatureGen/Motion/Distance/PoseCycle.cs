using System;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Poses;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Distance;

/// <summary>One cycle of a gait as poses at even places in it, and the pose of the creature at a stand: what is seen of it from afar. Immutable.</summary>
/// <remarks>Only joints that turn so far that it is seen are kept; all rotations are on the side of those at a stand, so that a mean of three is a sum brought to unit length.</remarks>
internal sealed class PoseCycle
{
    /// <summary>Poses in a cycle: with these a straight line from one to the next is no more than a degree off the recorded gait.</summary>
    public const int Frames = 24;

    /// <summary>Half the angle, radians, and metres of a body one metre high, that a joint leaves the stand at the most where that is not seen.</summary>
    private const float UnseenTurn = 0.01f;
    private const float UnseenShift = 0.002f;

    private readonly LocalPose stand;
    private readonly int[] turning;
    private readonly int[] shifting;
    private readonly Vector4[] standTurns;
    private readonly Vector4[] turns;
    private readonly Vector3[] shifts;

    /// <summary>Keeps what is seen of a recording.</summary>
    /// <param name="stand">The pose at a stand, in the parents' space.</param>
    /// <param name="frames">One pose for each frame, and one more with which the next cycle begins.</param>
    /// <param name="height">Of the standing body, metres.</param>
    /// <param name="stride">Metres that it went in the cycle.</param>
    public PoseCycle(LocalPose stand, LocalPose[] frames, float height, float stride)
    {
        this.stand = stand;
        Stride = stride;
        int count = stand.Pose.Rotations.Length;
        turning = Array.FindAll(Numbers(count), joint => Turns(stand, frames, joint));
        shifting = Array.FindAll(Numbers(count), joint => Shifts(stand, frames, joint, UnseenShift * height));
        standTurns = Array.ConvertAll(turning, joint => Row(stand.Pose.Rotations[joint]));
        turns = new Vector4[Frames * turning.Length];
        shifts = new Vector3[Frames * shifting.Length];
        for (int frame = 0; frame < Frames; frame++)
        {
            // What is left between the last pose and the first is spread evenly.
            float part = frame / (float)Frames;
            for (int i = 0; i < turning.Length; i++)
            {
                int joint = turning[i];
                Vector4 gap = Near(frames[0], joint, standTurns[i]) - Near(frames[Frames], joint, standTurns[i]);
                turns[(frame * turning.Length) + i] = Unit(Near(frames[frame], joint, standTurns[i]) + (gap * part));
            }

            for (int i = 0; i < shifting.Length; i++)
            {
                Vector3 gap = frames[0].Pose.Positions[shifting[i]] - frames[Frames].Pose.Positions[shifting[i]];
                shifts[(frame * shifting.Length) + i] = frames[frame].Pose.Positions[shifting[i]] + (gap * part);
            }
        }
    }

    /// <summary>Metres that the creature went in a cycle.</summary>
    public float Stride { get; }

    /// <summary>Writes the pose at a place in the cycle.</summary>
    /// <param name="phase">0..1.</param>
    /// <param name="weight">0 the stand, 1 the whole of the stride.</param>
    /// <param name="local">Receives the pose in the parents' space.</param>
    public void Pose(float phase, float weight, in Pose local)
    {
        stand.Pose.Rotations.CopyTo(local.Rotations);
        stand.Pose.Positions.CopyTo(local.Positions);
        if (weight == 0f)
        {
            return;
        }

        float place = phase * Frames;
        int frame = Math.Min((int)place, Frames - 1);
        int next = frame + 1 < Frames ? frame + 1 : 0;
        float later = (place - frame) * weight;
        float now = weight - later;
        float still = 1f - weight;
        ReadOnlySpan<Vector4> first = turns.AsSpan(frame * turning.Length, turning.Length);
        ReadOnlySpan<Vector4> second = turns.AsSpan(next * turning.Length, turning.Length);
        int done = 0;
#if NET
        if (EightVectors.Pay)
        {
            done = RotationBlend.Between(turning, standTurns, still, first, now, second, later, MemoryMarshal.Cast<Quaternion, Vector4>(local.Rotations));
        }
#endif
        for (int i = done; i < first.Length; i++)
        {
            Vector4 turn = Unit((standTurns[i] * still) + (first[i] * now) + (second[i] * later));
            ref Quaternion shown = ref local.Rotations[turning[i]];
            shown.X = turn.X;
            shown.Y = turn.Y;
            shown.Z = turn.Z;
            shown.W = turn.W;
        }

        for (int i = 0; i < shifting.Length; i++)
        {
            ref Vector3 shown = ref local.Positions[shifting[i]];
            shown = (shown * still) + (shifts[(frame * shifting.Length) + i] * now) + (shifts[(next * shifting.Length) + i] * later);
        }
    }

    private static int[] Numbers(int count)
    {
        var numbers = new int[count];
        for (int i = 0; i < count; i++)
        {
            numbers[i] = i;
        }

        return numbers;
    }

    private static bool Turns(LocalPose stand, LocalPose[] frames, int joint)
    {
        Vector4 still = Row(stand.Pose.Rotations[joint]);
        return Array.Exists(frames, frame => Squared(Near(frame, joint, still) - still) > UnseenTurn * UnseenTurn);
    }

    private static bool Shifts(LocalPose stand, LocalPose[] frames, int joint, float unseen)
    {
        Vector3 still = stand.Pose.Positions[joint];
        return Array.Exists(frames, frame => Vec.Distance(frame.Pose.Positions[joint], still) > unseen);
    }

    /// <summary>A rotation on the side of another.</summary>
    private static Vector4 Near(LocalPose frame, int joint, Vector4 other)
    {
        Vector4 turn = Row(frame.Pose.Rotations[joint]);
        Vector4 product = turn * other;
        return (product.X + product.Y) + (product.Z + product.W) < 0f ? -turn : turn;
    }

    private static Vector4 Row(Quaternion q) => new(q.X, q.Y, q.Z, q.W);

    private static Vector4 Unit(Vector4 turn) => turn * (1f / (float)Math.Sqrt(Squared(turn)));

    private static float Squared(Vector4 v)
    {
        Vector4 squares = v * v;
        return (squares.X + squares.Y) + (squares.Z + squares.W);
    }
}
