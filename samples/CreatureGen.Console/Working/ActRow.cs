using System;
using System.Linq;
using CreatureGen.Console.Arguments;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Preview.Films;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Sheets;

namespace CreatureGen.Console.Working;

/// <summary>Moments of an act of a creature, side by side.</summary>
internal static class ActRow
{
    /// <summary>How many.</summary>
    public const int Moments = 6;

    /// <summary>Pixels.</summary>
    private const int LabelHeight = 16;

    private static readonly Pixel paper = new(236, 237, 240);

    /// <summary>The cells of one creature: ends of phases, spread over the act, its contact or the end of what lasts among them; none where it cannot do it.</summary>
    /// <param name="profile">The creature's.</param>
    /// <param name="word">The act.</param>
    /// <param name="label">The creature's name.</param>
    /// <param name="options">How it is filmed.</param>
    /// <param name="wrong">Makes an error of what was expected.</param>
    public static SheetCell[] Of(MotionProfile profile, string word, string label, FilmOptions options, Func<string, Exception> wrong)
    {
        ActAbility ability = ActArguments.Named(profile, word, wrong);
        if (!ability.IsPossible)
        {
            return [];
        }

        CourseScript script = ActScript.Of(ability, ActTarget.Usual);
        var film = new CourseFilm(profile, script, CourseGround.Flat, options with { Height = Math.Max(options.Height - LabelHeight, LabelHeight) });
        float before = script.Commands[0].Seconds;
        int phases = ability.Act.Phases.Count;
        int told = Math.Max(0, ability.Act.Phases.ToList().FindIndex(phase => phase.Mark is ActMark.Contact or ActMark.SoundBegin || phase.Lasts));
        return Enumerable.Range(0, Moments).Select(i =>
        {
            // The third is what the act is about.
            double at = i <= 2 ? (told + 1) * (i + 1) / 3.0 : told + 1 + ((phases - told - 1) * (i - 2) / 3.0);
            (string name, float seconds) = Place(ability, at);
            int frame = Math.Min((int)((before + seconds) * 1000f / film.MillisecondsPerFrame), film.FrameCount - 1);
            return new SheetCell($"{label} {name}", (width, height) => Below(film.Frame(frame), width, height));
        }).ToArray();
    }

    /// <summary>A frame, which has a label of its own, below that of its cell.</summary>
    private static Picture Below(Picture frame, int width, int height)
    {
        var cell = new Picture(width, height, PixelLayout.Rgb);
        cell.Fill(paper);
        cell.Blit(frame, 0, LabelHeight);
        return cell;
    }

    /// <summary>The phase and the seconds of a place in an act, phases counted from 0 to their number.</summary>
    private static (string Name, float Seconds) Place(ActAbility ability, double at)
    {
        int phase = Math.Clamp((int)Math.Ceiling(at) - 1, 0, ability.Act.Phases.Count - 1);
        float begin = phase == 0 ? 0f : ability.SecondsTo(phase - 1);
        return (ability.Act.Phases[phase].Name, begin + ((float)(at - phase) * (ability.SecondsTo(phase) - begin)));
    }
}
