using System;
using System.Collections.Generic;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>The gaits that a creature goes through from standing to its top speed, and the speeds at which it changes. Immutable.</summary>
/// <remarks>
/// Speeds follow from the Froude number Fr = v²/(gℓ): animals of all sizes change gait at about the same one (Alexander and Jayes 1983; Griffin et al. 2004: horses of 0.7–1.4 m go over
/// from walk to trot at Fr = 0.35). The top speed is that of the fastest gait, or less where its steps would come quicker than 6·M^−0.14 per second (after Heglund and Taylor 1988).
/// </remarks>
public sealed class GaitSet
{
    private const double QuickestAtOneKilogram = 6;
    private const double QuickestExponent = -0.14;

    /// <summary>Part of a gait's comfortable Froude number below which steps get shorter instead of slower, unless those come too quick already.</summary>
    private const float SlowestFraction = 0.25f;

    /// <summary>Strides are not shortened for short legs below this part of what the gait asks for.</summary>
    private const float ShortestFraction = 0.2f;

    private readonly GaitStep[] steps;
    private readonly GaitSpeed[] speeds;

    /// <summary>Puts gaits in order.</summary>
    /// <param name="steps">From slow to fast, at least one; the first is entered from standing and its thresholds do not count.</param>
    /// <param name="legLength">From hip to ground, metres.</param>
    /// <param name="mass">Kilograms.</param>
    /// <param name="gravity">Metres per second squared.</param>
    /// <exception cref="ArgumentException">There is no gait, a gait is not sound, or thresholds do not rise.</exception>
    public GaitSet(IReadOnlyList<GaitStep> steps, float legLength, float mass, float gravity = StandardGravity.Acceleration)
        : this(steps, legLength, mass, gravity, null)
    {
    }

    /// <summary>The same with the longest way that feet can go along the ground in a stance, for each gait: legs that reach no further take quicker steps.</summary>
    internal GaitSet(IReadOnlyList<GaitStep> steps, float legLength, float mass, float gravity, Func<Gait, float>? longestStance)
    {
        if (steps == null || steps.Count == 0)
        {
            throw new ArgumentException("there are no gaits; expected at least one", nameof(steps));
        }

        Finite.RequireWithin(legLength, 1e-4f, 1e4f, nameof(legLength));
        Finite.RequireWithin(mass, 1e-9f, 1e12f, nameof(mass));
        Finite.RequireWithin(gravity, 1e-3f, 1e3f, nameof(gravity));
        this.steps = new List<GaitStep>(steps).ToArray();
        for (int i = 0; i < this.steps.Length; i++)
        {
            this.steps[i].Gait.ThrowIfInvalid();
            if (i > 0 && !(this.steps[i].Enter > this.steps[i].Leave && this.steps[i].Leave > (i > 1 ? this.steps[i - 1].Leave : 0f)))
            {
                throw new ArgumentException(FormattableString.Invariant($"{this.steps[i].Gait.Name} is entered at {this.steps[i].Enter} and left at {this.steps[i].Leave}; expected to leave below where it enters, and above where the gait before is left"), nameof(steps));
            }
        }

        speeds = new GaitSpeed[this.steps.Length];
        float unit = gravity * legLength;
        for (int i = 0; i < speeds.Length; i++)
        {
            Gait gait = this.steps[i].Gait;
            float max = Math.Min(gait.Fastest, QuickestFroude(gait, legLength, mass, gravity, longestStance == null ? float.MaxValue : longestStance(gait)));
            if (i + 1 < speeds.Length)
            {
                max = Math.Min(max, this.steps[i + 1].Enter);
            }

            float min = i == 0 ? 0f : this.steps[i].Leave;
            float comfortable = Math.Min(Math.Max(gait.Comfortable, min), max);
            speeds[i] = new GaitSpeed(gait, Speed(min), Speed(comfortable), Speed(Math.Max(max, min)));
        }

        TopSpeed = 0f;
        foreach (GaitSpeed speed in speeds)
        {
            TopSpeed = Math.Max(TopSpeed, speed.Fastest);
        }

        float Speed(float froude) => (float)Math.Sqrt(froude * unit);
    }

    /// <summary>Gaits and thresholds, slow to fast.</summary>
    public IReadOnlyList<GaitStep> Steps => steps;

    /// <summary>Gaits and their speeds, slow to fast.</summary>
    public IReadOnlyList<GaitSpeed> Speeds => speeds;

    /// <summary>Metres per second that the creature can keep up at most.</summary>
    public float TopSpeed { get; }

    /// <summary>The gait for a speed.</summary>
    /// <param name="current">Place of the present gait.</param>
    /// <param name="froude">v²/(gℓ).</param>
    /// <returns>Place of the gait to go on with.</returns>
    public int Choose(int current, float froude)
    {
        int chosen = Math.Min(Math.Max(current, 0), steps.Length - 1);
        while (chosen + 1 < steps.Length && froude > steps[chosen + 1].Enter)
        {
            chosen++;
        }

        while (chosen > 0 && froude < steps[chosen].Leave)
        {
            chosen--;
        }

        return chosen;
    }

    /// <summary>Cycles per second of a gait on legs that reach no further than a stance allows: at low speeds no more than the mass lets them, which short strides would ask for.</summary>
    internal static float FrequencyOf(Gait gait, float froude, float legLength, float gravity, float longestStance, float quickest)
    {
        float fr = Math.Max(froude, SlowestFraction * gait.Comfortable);
        float free = legLength * gait.Stride.At(fr);
        float stride = Math.Max(Math.Min(free, longestStance / gait.Duty.At(froude)), ShortestFraction * free);
        float unit = gravity * legLength;

        // Legs that cannot stride out need not hurry before they go as fast as asks for it.
        return Math.Max(Math.Min((float)Math.Sqrt(fr * unit) / free, quickest), (float)Math.Sqrt(froude * unit) / stride);
    }

    /// <summary>Cycles per second that a creature's mass lets it take at most.</summary>
    /// <param name="mass">Kilograms.</param>
    internal static float QuickestOf(float mass) => (float)(QuickestAtOneKilogram * PortableMath.Pow(mass, QuickestExponent));

    /// <summary>The Froude number at which a gait's steps come as quick as the creature's mass lets them.</summary>
    private static float QuickestFroude(Gait gait, float legLength, float mass, float gravity, float longestStance)
    {
        float quickest = QuickestOf(mass);
        float min = 0f;
        float max = gait.Fastest;
        if (FrequencyOf(gait, max, legLength, gravity, longestStance, quickest) <= quickest)
        {
            return max;
        }

        for (int i = 0; i < 24; i++)
        {
            float middle = 0.5f * (min + max);
            if (FrequencyOf(gait, middle, legLength, gravity, longestStance, quickest) <= quickest)
            {
                min = middle;
            }
            else
            {
                max = middle;
            }
        }

        return min;
    }
}
