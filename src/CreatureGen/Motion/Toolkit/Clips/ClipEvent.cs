using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Something that happens at a time of a clip: for sounds, dust and prints.</summary>
public sealed record ClipEvent
{
    /// <summary>Takes an event.</summary>
    /// <param name="time">Seconds from the beginning of the clip, not below 0.</param>
    /// <param name="name">What happens, as <c>footstep</c>.</param>
    /// <param name="joint">Name of the joint at which it happens; empty for the whole creature.</param>
    /// <param name="strength">How strongly, 1 being usual.</param>
    /// <exception cref="ArgumentNullException">A name is null.</exception>
    /// <exception cref="ArgumentException">The name is empty, or a number is not finite or below 0.</exception>
    public ClipEvent(float time, string name, string joint, float strength)
    {
        Finite.RequireWithin(time, 0f, float.MaxValue, nameof(time));
        Finite.RequireWithin(strength, 0f, float.MaxValue, nameof(strength));
        Time = time;
        Name = name ?? throw new ArgumentNullException(nameof(name));
        Joint = joint ?? throw new ArgumentNullException(nameof(joint));
        Strength = strength;
        if (name.Length == 0)
        {
            throw new ArgumentException("an event without a name; expected one, as footstep", nameof(name));
        }
    }

    /// <summary>Seconds from the beginning of the clip.</summary>
    public float Time { get; }

    /// <summary>What happens.</summary>
    public string Name { get; }

    /// <summary>Name of the joint at which it happens; empty for the whole creature.</summary>
    public string Joint { get; }

    /// <summary>How strongly, 1 being usual.</summary>
    public float Strength { get; }
}
