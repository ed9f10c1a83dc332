using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>A stretch of an act: where each channel that it names goes in it. Channels that it does not name stay where they are. Immutable; what seems to change one gives another.</summary>
public sealed class ActPhase
{
    private const float LongestDuration = 1000f;
    private const float FarthestValue = 100f;

    private readonly (ActChannel Channel, float Value)[] ends;
    private readonly ActWave[] waves;

    /// <summary>A phase that keeps everything as it is.</summary>
    /// <param name="name">What it is called.</param>
    /// <param name="duration">How long it takes, times √(leg length / gravity): 0.1 s on a leg of 0.1 m, 0.32 s on one of 1 m. Above 0.</param>
    /// <param name="ease">How channels go.</param>
    /// <exception cref="ArgumentNullException">There is no name.</exception>
    /// <exception cref="ArgumentException">The duration is not finite or not above 0.</exception>
    public ActPhase(string name, float duration, ActEase ease = ActEase.Smooth)
        : this(name ?? throw new ArgumentNullException(nameof(name)), duration, ease, Array.Empty<(ActChannel, float)>(), Array.Empty<ActWave>())
    {
        Finite.RequireWithin(duration, 1e-3f, LongestDuration, nameof(duration));
    }

    private ActPhase(string name, float duration, ActEase ease, (ActChannel Channel, float Value)[] ends, ActWave[] waves)
    {
        Name = name;
        Duration = duration;
        Ease = ease;
        this.ends = ends;
        this.waves = waves;
    }

    /// <summary>What it is called.</summary>
    public string Name { get; }

    /// <summary>How long it takes, times √(leg length / gravity).</summary>
    public float Duration { get; }

    /// <summary>How channels go.</summary>
    public ActEase Ease { get; }

    /// <summary>Seconds that it takes at least, however small the creature: what a player has to see needs 0.18.</summary>
    public float MinSeconds { get; private set; }

    /// <summary>Whether it goes on until the animator is told to go on.</summary>
    public bool Lasts { get; private set; }

    /// <summary>What happens at its end.</summary>
    public ActMark Mark { get; private set; }

    /// <summary>Where channels are at its end.</summary>
    public IReadOnlyList<(ActChannel Channel, float Value)> Ends => ends;

    /// <summary>What swings in it.</summary>
    public IReadOnlyList<ActWave> Waves => waves;

    /// <summary>What swings, without a call for each.</summary>
    internal ReadOnlySpan<ActWave> AllWaves => waves;

    /// <summary>The same with a channel at a value at its end.</summary>
    /// <param name="channel">What.</param>
    /// <param name="value">Where, in the channel's unit; −100..100.</param>
    /// <exception cref="ArgumentException">The value is not finite or out of its range, or there is no such channel.</exception>
    public ActPhase To(ActChannel channel, float value)
    {
        Require(channel, nameof(channel));
        Finite.RequireWithin(value, -FarthestValue, FarthestValue, nameof(value));
        return Copy(ends.Where(end => end.Channel != channel).Append((channel, value)).ToArray(), waves);
    }

    /// <summary>The same with a swing.</summary>
    /// <param name="wave">The swing.</param>
    /// <exception cref="ArgumentException">A number of it is not finite or out of its range.</exception>
    public ActPhase With(ActWave wave)
    {
        Require(wave.Channel, nameof(wave));
        Finite.RequireWithin(wave.Size, -FarthestValue, FarthestValue, nameof(ActWave.Size));
        Finite.RequireWithin(wave.Cycles, 0f, 100f, nameof(ActWave.Cycles));
        Finite.RequireWithin(wave.Lag, -1f, 1f, nameof(ActWave.Lag));
        return Copy(ends, waves.Append(wave).ToArray());
    }

    /// <summary>The same with something that happens at its end.</summary>
    public ActPhase Then(ActMark mark)
    {
        ActPhase copy = Copy(ends, waves);
        copy.Mark = mark;
        return copy;
    }

    /// <summary>The same, no shorter than so many seconds.</summary>
    /// <exception cref="ArgumentException">The time is not finite or not within 0..60.</exception>
    public ActPhase AtLeast(float seconds)
    {
        Finite.RequireWithin(seconds, 0f, 60f, nameof(seconds));
        ActPhase copy = Copy(ends, waves);
        copy.MinSeconds = seconds;
        return copy;
    }

    /// <summary>The same, until the animator is told to go on; its waves swing on with the period that they have.</summary>
    public ActPhase Lasting()
    {
        ActPhase copy = Copy(ends, waves);
        copy.Lasts = true;
        return copy;
    }

    /// <inheritdoc/>
    public override string ToString() => Name;

    private static void Require(ActChannel channel, string name)
    {
        if (channel is < ActChannel.Ahead or > ActChannel.Reach)
        {
            throw new ArgumentOutOfRangeException(name, channel, "there is no such channel");
        }
    }

    private ActPhase Copy((ActChannel Channel, float Value)[] newEnds, ActWave[] newWaves) =>
        new(Name, Duration, Ease, newEnds, newWaves) { MinSeconds = MinSeconds, Lasts = Lasts, Mark = Mark };
}
