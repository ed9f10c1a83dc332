using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>
/// Several clips of one skeleton as one, in step with each other: a walk and a run at the same part of their cycles, at a cycle as long as the weights make it. Weights may change while it plays.
/// Sampling and changing weights allocate nothing. For one thread at a time.
/// </summary>
/// <remarks>
/// At weights w the cycle lasts Σ w·duration, a stride is Σ w·speed·duration long, and speed is stride over cycle. Clips have to begin at the same moment of their cycle, as baked ones do.
/// Based on: C. Rose, M. F. Cohen and B. Bodenheimer, "Verbs and adverbs" (1998), for blending at equal phases.
/// </remarks>
public sealed class PhaseBlend : IClip
{
    private readonly IClip[] clips;
    private readonly float[] weights;
    private readonly Quaternion[] rotations;
    private readonly Vector3[] positions;
    private readonly float[] totals;

    /// <summary>Takes the clips; the first has all the weight.</summary>
    /// <param name="name">Not empty.</param>
    /// <param name="clips">Clips of as many joints that all loop, or all stay at their ends; one at least.</param>
    /// <exception cref="ArgumentNullException">The list or a clip is null.</exception>
    /// <exception cref="ArgumentException">The name or the list is empty, or clips differ in joints or ends.</exception>
    public PhaseBlend(string name, IReadOnlyList<IClip> clips)
    {
        if (string.IsNullOrEmpty(name))
        {
            throw new ArgumentException("a blend has no name; expected one", nameof(name));
        }

        Name = name;
        this.clips = new List<IClip>(clips ?? throw new ArgumentNullException(nameof(clips))).ToArray();
        if (this.clips.Length == 0)
        {
            throw new ArgumentException($"blend {name} has no clips; expected one at least", nameof(clips));
        }

        foreach (IClip clip in this.clips)
        {
            _ = clip ?? throw new ArgumentNullException(nameof(clips));
            if (clip.Joints != this.clips[0].Joints || clip.End != this.clips[0].End)
            {
                throw new ArgumentException(FormattableString.Invariant($"clip {clip.Name} has {clip.Joints} joints and {clip.End}; expected {this.clips[0].Joints} and {this.clips[0].End} like {this.clips[0].Name}"), nameof(clips));
            }
        }

        weights = new float[this.clips.Length];
        weights[0] = 1f;
        rotations = new Quaternion[Joints];
        positions = new Vector3[Joints];
        totals = new float[Joints];
        Heaviest = this.clips[0];
    }

    /// <inheritdoc/>
    public string Name { get; }

    /// <inheritdoc/>
    public ClipEnd End => clips[0].End;

    /// <inheritdoc/>
    public int Joints => clips[0].Joints;

    /// <summary>The clips.</summary>
    public IReadOnlyList<IClip> Clips => clips;

    /// <summary>The weight of each clip, together 1.</summary>
    public ReadOnlySpan<float> Weights => weights;

    /// <summary>The clip of the largest weight, the first of equal ones: its events happen.</summary>
    public IClip Heaviest { get; private set; }

    /// <summary>The events of the heaviest clip, at that clip's own times.</summary>
    public IReadOnlyList<ClipEvent> Events => Heaviest.Events;

    /// <inheritdoc/>
    public float EventSpan => Heaviest.EventSpan;

    /// <inheritdoc/>
    public float Duration
    {
        get
        {
            float sum = 0f;
            for (int i = 0; i < clips.Length; i++)
            {
                sum += weights[i] * clips[i].Duration;
            }

            return sum;
        }
    }

    /// <inheritdoc/>
    public float Speed
    {
        get
        {
            float stride = 0f;
            for (int i = 0; i < clips.Length; i++)
            {
                stride += weights[i] * clips[i].Speed * clips[i].Duration;
            }

            return stride / Duration;
        }
    }

    /// <summary>Gives each clip its weight.</summary>
    /// <param name="fractions">One for each clip, none below 0, one above; they are divided by their sum.</param>
    /// <exception cref="ArgumentException">Their number is not that of the clips, or one is not finite or below 0, or all are 0.</exception>
    public void SetWeights(ReadOnlySpan<float> fractions)
    {
        float sum = 0f;
        foreach (float fraction in fractions)
        {
            Finite.RequireWithin(fraction, 0f, float.MaxValue, nameof(fractions));
            sum += fraction;
        }

        if (fractions.Length != clips.Length || !(sum > 0f && sum <= float.MaxValue))
        {
            throw new ArgumentException(FormattableString.Invariant($"{fractions.Length} weights of the sum {sum}; expected one for each of {clips.Length} clips, one of them above 0"), nameof(fractions));
        }

        int heaviest = 0;
        for (int i = 0; i < weights.Length; i++)
        {
            weights[i] = fractions[i] / sum;
            heaviest = weights[i] > weights[heaviest] ? i : heaviest;
        }

        Heaviest = clips[heaviest];
    }

    /// <summary>Gives the weight to the clips around a speed, for clips in the order of their speeds: what plays goes at that speed, or at the nearest that the clips have.</summary>
    /// <param name="speed">Metres per second.</param>
    /// <exception cref="ArgumentException">The speed is not finite.</exception>
    public void SetSpeed(float speed)
    {
        Finite.Require(speed, nameof(speed));
        int upper = 1;
        while (upper < clips.Length - 1 && clips[upper].Speed < speed)
        {
            upper++;
        }

        Array.Clear(weights, 0, weights.Length);
        int lower = Math.Max(upper - 1, 0);
        upper = Math.Min(upper, clips.Length - 1);

        // Of (1 − w) a and w b with speeds u, v and durations d, e: (1 − w) d (u − speed) + w e (v − speed) = 0.
        float below = clips[lower].Duration * (speed - clips[lower].Speed);
        float above = clips[upper].Duration * (clips[upper].Speed - speed);
        float fraction = below <= 0f ? 0f : above <= 0f ? 1f : below / (below + above);
        weights[lower] = 1f - fraction;
        weights[upper] += fraction;
        Heaviest = clips[fraction > 0.5f ? upper : lower];
    }

    /// <inheritdoc/>
    public void Sample(float time, in Pose local)
    {
        float phase = ClipTime.Within(time, Duration, End) / Duration;
        var sampled = new Pose(rotations, positions);
        if (weights[Array.IndexOf(clips, Heaviest)] >= 1f)
        {
            Heaviest.Sample(phase * Heaviest.Duration, local);
            return;
        }

        var mixer = new PoseMixer(local, totals);
        for (int i = 0; i < clips.Length; i++)
        {
            if (weights[i] > 0f)
            {
                clips[i].Sample(phase * clips[i].Duration, sampled);
                mixer.Add(sampled, weights[i]);
            }
        }

        mixer.Finish(sampled);
    }
}
