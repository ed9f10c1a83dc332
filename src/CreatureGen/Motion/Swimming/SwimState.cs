using CreatureGen.Maths;
using CreatureGen.Motion.Modes;

namespace CreatureGen.Motion.Swimming;

/// <summary>Where a swimmer is in its motion. The default is at rest in still water; one for each creature on the scene, changed by <see cref="SwimMotion.Update"/> alone.</summary>
internal struct SwimState
{
    /// <summary>Factor on the bank of turns, as set.</summary>
    internal double Lean;

    internal double Phase;
    internal CriticallyDampedSpring Frequency;
    internal CriticallyDampedSpring Amplitude;
    internal Momentum Ahead;
    internal Momentum Rise;
    internal CriticallyDampedSpring Turn;
    internal CriticallyDampedSpring Bend;

    /// <summary>The bend of its tail, which gets to where its head was later.</summary>
    internal CriticallyDampedSpring TailBend;
    internal CriticallyDampedSpring Climb;
    internal CriticallyDampedSpring Brake;

    /// <summary>How hard it works to get faster, 0..1: its body bends with its beat.</summary>
    internal CriticallyDampedSpring Stroke;
    internal PushOff Push;
    internal double EscapeAge;
    internal double EscapeSide;
    internal EscapeTurn LastEscape;

    /// <summary>Place in the cycle of the tail's beat (of the flippers' stroke), 0..1.</summary>
    public readonly float CyclePhase => (float)Phase;

    /// <summary>Beats per second at present.</summary>
    public readonly float BeatFrequency => (float)Frequency.Value;

    /// <summary>Width of the beat at present, 1 at cruise.</summary>
    public readonly float BeatAmplitude => (float)Amplitude.Value;

    /// <summary>Metres of the model per second ahead at present, without what a C-start adds; negative backs up.</summary>
    public readonly float Speed => (float)Ahead.Speed;

    /// <summary>Whether a C-start is under way, as its progress: 0 none, then rising to 1 at its end.</summary>
    public readonly float EscapeProgress => EscapeSide == 0 ? 0f : (float)System.Math.Min(EscapeAge / EscapeCurve.Duration, 1);
}
