using System;
using System.Collections.Generic;
using System.Globalization;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Motion.Metrics;

/// <summary>How long the updates of a course are: all alike, or as uneven as those of a game that stutters.</summary>
public readonly record struct CourseRate
{
    private const double HitchChance = 0.02;
    private const double Hitch = 0.25;

    private static readonly double[] unevenSteps = { 0.004, 0.016, 0.033, 0.1 };

    private CourseRate(float? hertz) => Hertz = hertz;

    /// <summary>Updates of 4, 16, 33 and 100 ms in random order, and now and then one of 250 ms.</summary>
    public static CourseRate Uneven => default;

    /// <summary>Updates per second; null where they are uneven.</summary>
    public float? Hertz { get; }

    /// <summary>Updates that are all alike.</summary>
    /// <param name="hertz">Updates per second, 4..1000.</param>
    /// <exception cref="ArgumentException">The rate is not within its range.</exception>
    public static CourseRate Of(float hertz)
    {
        Finite.RequireWithin(hertz, 4f, 1000f, nameof(hertz));
        return new CourseRate(hertz);
    }

    /// <summary>The lengths of the updates in seconds, without end.</summary>
    /// <param name="seed">Decides the order of uneven ones.</param>
    public IEnumerable<double> Steps(Seed seed)
    {
        RandomStream random = seed.Child("steps").Stream();
        while (true)
        {
            yield return Hertz is float hertz ? 1.0 / hertz
                : random.Chance(HitchChance) ? Hitch
                : unevenSteps[random.Integer(0, unevenSteps.Length)];
        }
    }

    /// <summary>As reports have it: a number, or <c>uneven</c>.</summary>
    public override string ToString() => Hertz is float hertz ? hertz.ToString(CultureInfo.InvariantCulture) : "uneven";
}
