using System;
using CreatureGen.Motion.Grounds;

namespace CreatureGen.Motion;

/// <summary>Many of one creature on the scene, updated in one call: each moves exactly as with a <see cref="CreatureAnimator"/> of its own, bit for bit.</summary>
/// <remarks>
/// <para>One after the other they read what is known of their creature, which so stays in the nearest cache, and what each of them remembers lies side by side in memory.</para>
/// <para>A crowd starts no threads. Any number of threads may update different members at once by <see cref="Update(int, float, ReadOnlySpan{MotionInput}, IGround)"/>; where each ends does not depend on how they are shared out. Their ground then has to stand being asked by all of them. An update allocates nothing.</para>
/// </remarks>
public sealed class Crowd
{
    private readonly CreatureAnimator[] members;

    /// <summary>A crowd that stands at the origin; <see cref="CreatureAnimator.Teleport"/> puts each where it is to be.</summary>
    /// <param name="profile">What is known of the creature.</param>
    /// <param name="count">How many there are, 0 or more.</param>
    /// <exception cref="ArgumentNullException">There is no profile.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The count is below 0.</exception>
    public Crowd(MotionProfile profile, int count)
    {
        Profile = profile ?? throw new ArgumentNullException(nameof(profile));
        if (count < 0)
        {
            throw new ArgumentOutOfRangeException(nameof(count), count, "expected 0 or more");
        }

        members = new CreatureAnimator[count];
        for (int i = 0; i < count; i++)
        {
            members[i] = new CreatureAnimator(profile);
        }
    }

    /// <summary>What is known of the creature's way of going.</summary>
    public MotionProfile Profile { get; }

    /// <summary>How many there are.</summary>
    public int Count => members.Length;

    /// <summary>One of the crowd: its place, pose, events and settings. It may also be updated alone.</summary>
    /// <param name="index">0 up to <see cref="Count"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such member.</exception>
    public CreatureAnimator this[int index] => (uint)index < (uint)members.Length
        ? members[index]
        : throw new ArgumentOutOfRangeException(nameof(index), index, FormattableString.Invariant($"expected 0..{members.Length - 1}"));

    /// <summary>Moves all of them on.</summary>
    /// <param name="dt">Seconds since the last update, 0..0.25; what is longer counts as 0.25.</param>
    /// <param name="inputs">What each is to do, <see cref="Count"/> of them.</param>
    /// <param name="ground">Where feet find footing.</param>
    /// <exception cref="ArgumentException">There are more or fewer inputs than members, a number is not finite or out of its range, or dt is negative. Nothing has changed.</exception>
    /// <exception cref="ArgumentNullException">There is no ground. Nothing has changed.</exception>
    /// <exception cref="Exception">The ground has thrown it. Those before have moved on; the one for which it was asked, and those after it, are as they were before.</exception>
    public void Update(float dt, ReadOnlySpan<MotionInput> inputs, IGround ground)
    {
        if (inputs.Length != members.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"{inputs.Length} inputs; expected {members.Length}, one for each member"), nameof(inputs));
        }

        Update(0, dt, inputs, ground);
    }

    /// <summary>Moves some of them on: the share of one thread, or those whose turn it is.</summary>
    /// <param name="first">Number of the first.</param>
    /// <param name="dt">Seconds since their last update, 0..0.25; what is longer counts as 0.25.</param>
    /// <param name="inputs">What each is to do, from the first on; how many there are is how many move.</param>
    /// <param name="ground">Where feet find footing.</param>
    /// <exception cref="ArgumentOutOfRangeException">There are no such members. Nothing has changed.</exception>
    /// <exception cref="ArgumentException">A number is not finite or out of its range, or dt is negative. Nothing has changed.</exception>
    /// <exception cref="ArgumentNullException">There is no ground. Nothing has changed.</exception>
    /// <exception cref="Exception">The ground has thrown it. Those before have moved on; the one for which it was asked, and those after it, are as they were before.</exception>
    public void Update(int first, float dt, ReadOnlySpan<MotionInput> inputs, IGround ground)
    {
        if (first < 0 || first > members.Length - inputs.Length)
        {
            throw new ArgumentOutOfRangeException(nameof(first), first, FormattableString.Invariant($"{inputs.Length} inputs; expected 0..{members.Length - inputs.Length}, for there are {members.Length} members"));
        }

        if (ground == null)
        {
            throw new ArgumentNullException(nameof(ground));
        }

        foreach (ref readonly MotionInput input in inputs)
        {
            // All before any moves, so that a wrong number changes nothing. The rest is refused by the first member.
            input.ThrowIfInvalid();
        }

        for (int i = 0; i < inputs.Length; i++)
        {
            members[first + i].Update(dt, inputs[i], ground);
        }
    }
}
