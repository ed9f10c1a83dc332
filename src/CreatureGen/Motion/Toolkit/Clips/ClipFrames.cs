using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Clips;

/// <summary>A clip frame by frame, track by track; signs of rotations do not jump, and a loop closes.</summary>
internal sealed class ClipFrames
{
    private readonly TrackFrames[] rotations;
    private readonly TrackFrames[] positions;

    /// <summary>Takes a clip apart.</summary>
    /// <param name="clip">What is taken apart.</param>
    /// <param name="rate">Frames per second at least, so that a whole number of them makes the clip.</param>
    public ClipFrames(IClip clip, int rate)
    {
        Clip = clip;
        Count = Math.Max(2, (int)Math.Ceiling((clip.Duration * (double)rate) - 1e-3) + 1);
        int joints = clip.Joints;
        var turns = new Vector4[joints][];
        var places = new Vector4[joints][];
        for (int joint = 0; joint < joints; joint++)
        {
            turns[joint] = new Vector4[Count];
            places[joint] = new Vector4[Count];
        }

        var pose = new Pose(new Quaternion[joints], new Vector3[joints]);
        bool loops = clip.End == ClipEnd.Loops;
        for (int frame = 0; frame < Count; frame++)
        {
            clip.Sample(loops && frame == Count - 1 ? 0f : TimeOf(frame), pose);
            for (int joint = 0; joint < joints; joint++)
            {
                Quaternion q = pose.Rotations[joint];
                var turn = new Vector4(q.X, q.Y, q.Z, q.W);
                bool flips = frame > 0 && Dot(turn, turns[joint][frame - 1]) < 0f;
                turns[joint][frame] = flips ? turn * -1f : turn;
                places[joint][frame] = new Vector4(pose.Positions[joint], 0f);
            }
        }

        rotations = Array.ConvertAll(turns, values => new TrackFrames(values, turns: true, loops));
        positions = Array.ConvertAll(places, values => new TrackFrames(values, turns: false, loops));
    }

    /// <summary>What was taken apart.</summary>
    public IClip Clip { get; }

    /// <summary>Number of frames, the last included.</summary>
    public int Count { get; }

    /// <summary>The rotation of a joint.</summary>
    public TrackFrames Rotation(int joint) => rotations[joint];

    /// <summary>The position of a joint.</summary>
    public TrackFrames Position(int joint) => positions[joint];

    /// <summary>Seconds from the beginning.</summary>
    public float TimeOf(int frame) => ClipError.PartOf(Clip.Duration, frame, Count);

    private static float Dot(Vector4 a, Vector4 b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z) + (a.W * b.W);
}
