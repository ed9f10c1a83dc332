using System;
using System.Numerics;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Playback;

/// <summary>A clip while it plays: its cursor, and where its root has travelled.</summary>
internal struct PlayingClip
{
    private ClipCursor cursor;
    private GroundPlace start;
    private GroundPlace end;
    private GroundPlace at;

    /// <summary>Begins.</summary>
    /// <param name="cursor">Where.</param>
    /// <param name="root">Number of the joint that travels; −1 for none.</param>
    /// <param name="scratch">Of the clip's joints.</param>
    public PlayingClip(in ClipCursor cursor, int root, in Pose scratch)
    {
        this.cursor = cursor;
        start = end = at = default;
        if (root >= 0)
        {
            start = GroundPlaceAt(cursor.Clip, 0f, root, scratch);
            end = GroundPlaceAt(cursor.Clip, cursor.Clip.Duration, root, scratch);
            at = GroundPlaceAt(cursor.Clip, cursor.Time, root, scratch);
        }
    }

    /// <summary>Where it is.</summary>
    public readonly ClipCursor Cursor => cursor;

    /// <summary>Goes to a time; the root goes with it and has not travelled.</summary>
    public void Seek(float time, int root, in Pose scratch)
    {
        cursor.Seek(time);
        this = new PlayingClip(cursor, root, scratch);
    }

    /// <summary>Lets it play, and gives its pose there.</summary>
    /// <param name="seconds">Of its own time.</param>
    /// <param name="root">Number of the joint that travels; −1 for none.</param>
    /// <param name="local">Receives the pose, in place.</param>
    /// <param name="travelled">How far its root went.</param>
    public ClipPassage Advance(float seconds, int root, in Pose local, out RootDelta travelled)
    {
        ClipPassage passage = cursor.Advance(seconds);
        cursor.Clip.Sample(cursor.Time, local);
        travelled = new RootDelta(new Vector3(0f, 0f, cursor.Clip.Speed * seconds), 0f);
        if (root >= 0)
        {
            GroundPlace now = GroundPlace.Of(local.Positions[root], local.Rotations[root]);
            travelled = GroundPlace.Then(travelled, Way(passage.Rounds, now));
            start.TakeBack(now, ref local.Positions[root], ref local.Rotations[root]);
            at = now;
        }

        return passage;
    }

    private static GroundPlace GroundPlaceAt(IClip clip, float time, int root, in Pose scratch)
    {
        clip.Sample(time, scratch);
        return GroundPlace.Of(scratch.Positions[root], scratch.Rotations[root]);
    }

    private readonly RootDelta Way(int rounds, in GroundPlace now)
    {
        RootDelta way = default;
        GroundPlace from = at;
        for (int i = 0; i < Math.Abs(rounds); i++)
        {
            way = GroundPlace.Then(way, from.To(rounds > 0 ? end : start));
            from = rounds > 0 ? start : end;
        }

        return GroundPlace.Then(way, from.To(now));
    }
}
