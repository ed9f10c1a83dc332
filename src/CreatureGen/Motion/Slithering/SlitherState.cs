using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Slithering;

/// <summary>Where a crawler is in its motion, with the track that its head has left behind. One for each creature on the scene; made once, nothing is allocated later.</summary>
internal sealed class SlitherState
{
    internal CriticallyDampedSpring Speed;
    internal CriticallyDampedSpring Sidewinding;
    internal CriticallyDampedSpring Winding;
    internal CriticallyDampedSpring Idle;
    internal double Breath;
    internal double CourseAngle;
    internal bool Placed;
    internal RootPlace Root;
    internal Vector3 Middle;
    internal double Yaw;

    /// <summary>From the way to the middle line of the track, radians.</summary>
    internal double Slant;

    /// <summary>Metres on its way for each metre along its track.</summary>
    internal double Progress = 1;

    /// <summary>A crawler that lies where its root first is, in the bends of its way of crawling.</summary>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    public SlitherState(SlitherProfile profile)
    {
        if (profile == null)
        {
            throw new ArgumentNullException(nameof(profile));
        }

        Track = new SlitherTrack(profile.BodyLength, profile.Wavelength);
        Idle = CriticallyDampedSpring.At(1);
    }

    internal SlitherTrack Track { get; }

    /// <summary>Place in the wave at the head, 0..1.</summary>
    public float CyclePhase => (float)(Track.Head / Track.Wavelength - Math.Floor(Track.Head / Track.Wavelength));

    /// <summary>Takes over where another is.</summary>
    public void CopyFrom(SlitherState other)
    {
        Speed = other.Speed;
        Sidewinding = other.Sidewinding;
        Winding = other.Winding;
        Idle = other.Idle;
        Breath = other.Breath;
        CourseAngle = other.CourseAngle;
        Placed = other.Placed;
        Root = other.Root;
        Middle = other.Middle;
        Yaw = other.Yaw;
        Slant = other.Slant;
        Progress = other.Progress;
        Track.CopyFrom(other.Track);
    }

    /// <summary>Lays the crawler anew at its root with the next update: after a teleport without its shape.</summary>
    public void Reset()
    {
        Placed = false;
        Speed = default;
    }
}
