using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Where the playing of a clip is. A value to keep for each clip that plays; it advances by itself and tells what it passed.</summary>
/// <remarks>The place is kept as a part of the whole, so that a clip whose duration changes while it plays (<see cref="PhaseBlend"/>) goes on from the same moment of its cycle.</remarks>
public struct ClipCursor
{
    private double phase;

    /// <summary>Puts a cursor into a clip.</summary>
    /// <param name="clip">What plays.</param>
    /// <param name="time">Seconds from its beginning, as <see cref="ClipTime.Within"/> understands it.</param>
    /// <exception cref="ArgumentNullException">There is no clip.</exception>
    /// <exception cref="ArgumentException">The time is not finite.</exception>
    public ClipCursor(IClip clip, float time = 0f)
    {
        Clip = clip ?? throw new ArgumentNullException(nameof(clip));
        phase = 0;
        Seek(time);
    }

    /// <summary>What plays.</summary>
    public IClip Clip { get; }

    /// <summary>The part of the clip that has been played, 0..1; below 1 in a clip that loops.</summary>
    public readonly float Phase => (float)phase;

    /// <summary>Seconds from the beginning of the clip.</summary>
    public readonly float Time => (float)(phase * Clip.Duration);

    /// <summary>Whether a clip that stays at its end has come there.</summary>
    public readonly bool IsFinished => Clip.End == ClipEnd.Stays && phase >= 1;

    /// <summary>Goes to a time; nothing on the way there happens.</summary>
    /// <param name="time">Seconds from the beginning of the clip, as <see cref="ClipTime.Within"/> understands it.</param>
    /// <exception cref="ArgumentException">The time is not finite.</exception>
    public void Seek(float time) => SeekPhase(ClipTime.Within(time, Clip.Duration, Clip.End) / (double)Clip.Duration);

    /// <summary>Goes to a part of the clip, 0..1; nothing on the way there happens.</summary>
    /// <exception cref="ArgumentException">The part is not finite or out of its range.</exception>
    public void SeekPhase(double part)
    {
        if (!(part >= 0 && part <= 1))
        {
            throw new ArgumentException(FormattableString.Invariant($"the part {part} of a clip; expected 0..1"), nameof(part));
        }

        phase = part >= 1 && Clip.End == ClipEnd.Loops ? 0 : part;
    }

    /// <summary>Lets the clip play.</summary>
    /// <param name="seconds">Of the clip's own time; backwards if below 0.</param>
    /// <returns>What was passed on the way.</returns>
    /// <exception cref="ArgumentException">The time is not finite.</exception>
    public ClipPassage Advance(float seconds)
    {
        Finite.Require(seconds, nameof(seconds));
        double from = phase;
        double to = from + (seconds / (double)Clip.Duration);
        if (Clip.End == ClipEnd.Stays)
        {
            phase = Scalar.Clamp(to, 0, 1);
            return new ClipPassage(Clip, from, phase, 0);
        }

        double rounds = Math.Floor(to);
        phase = to - rounds;
        if (phase >= 1)
        {
            // A step back that is too small to be told from the end.
            phase = 0;
            rounds++;
        }

        return new ClipPassage(Clip, from, phase, (int)Scalar.Clamp(rounds, -ClipPassage.MaxRounds, ClipPassage.MaxRounds));
    }
}
