using System;
using System.Collections.Generic;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>A piece of motion that can be asked for its pose at any time.</summary>
public interface IClip
{
    /// <summary>Unique among the clips of a creature.</summary>
    string Name { get; }

    /// <summary>What becomes of it at its end.</summary>
    ClipEnd End { get; }

    /// <summary>Seconds from beginning to end.</summary>
    float Duration { get; }

    /// <summary>Metres per second ahead at which the creature has to be moved for its feet not to slide; 0 for a clip on the spot, and for one whose root travels by itself.</summary>
    float Speed { get; }

    /// <summary>Number of joints.</summary>
    int Joints { get; }

    /// <summary>What happens in it, in the order of time.</summary>
    IReadOnlyList<ClipEvent> Events { get; }

    /// <summary>Seconds over which <see cref="Events"/> lie: <see cref="Duration"/>, but in a clip that plays the events of another one at a pace of its own, that one's.</summary>
    float EventSpan { get; }

    /// <summary>The pose at a time. Nothing is allocated.</summary>
    /// <param name="time">Seconds from its beginning; before the beginning and after the end it is as <see cref="ClipTime.Within"/> says.</param>
    /// <param name="local">Receives the pose in the parents' space.</param>
    /// <exception cref="ArgumentException">The time is not finite, or the pose is of another number of joints.</exception>
    void Sample(float time, in Pose local);
}
