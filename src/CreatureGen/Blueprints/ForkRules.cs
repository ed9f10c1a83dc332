using System;
using CreatureGen.Anatomy;
using CreatureGen.Json;

namespace CreatureGen.Blueprints;

/// <summary>Where a body may fork into two necks: behind all that grows on its head, and in front of all limbs.</summary>
internal static class ForkRules
{
    /// <summary>The ring at which it forks where nothing is in the way.</summary>
    public const int Usual = StationRing.NeckBase;

    /// <summary>The foremost ring at which it may fork: in front of it too little neck is left.</summary>
    public const int Foremost = StationRing.TrunkFirst;

    /// <summary>The last ring of a head that is there twice: what grows on it goes with it, and what grows behind it does not.</summary>
    private const int HeadLast = StationRing.Nape;

    /// <summary>Lists what stands in the way of a fork.</summary>
    public static void Check(CreatureBlueprint blueprint, ProblemList problems)
    {
        if (blueprint.Fork is not ForkBlueprint fork)
        {
            return;
        }

        int first = FirstLimb(blueprint);
        if (fork.Ring >= first)
        {
            problems.Add("fork.ring", FormattableString.Invariant($"{fork.Ring}"), FormattableString.Invariant($"a ring in front of all limbs, the first of which begins at {first}"));
        }

        if (blueprint.Body?.Shell is ShellBlueprint shell && shell.Style != ShellStyle.None && shell.Ring < fork.Ring)
        {
            problems.Add("body.shell.ring", FormattableString.Invariant($"{shell.Ring}"), FormattableString.Invariant($"at least {fork.Ring}, where the body forks"));
        }

        if (blueprint.Body?.Disc is DiscBlueprint disc && (disc.Sweep != 0 || disc.Curl != 0))
        {
            problems.Add("fork", "a fork", "none on a body as wide as wings");
        }

        for (int i = 0; i < (blueprint.Ears?.Count ?? 0); i++)
        {
            SocketBlueprint? socket = blueprint.Ears![i]?.Socket;
            if (socket?.Ring + socket?.Rows > HeadLast)
            {
                problems.Add(FormattableString.Invariant($"ears[{i}].socket"), FormattableString.Invariant($"rings {socket!.Ring}..{socket.Ring + socket.Rows}"), FormattableString.Invariant($"rings up to {HeadLast}, the head's, of a body that forks"));
            }
        }

        for (int i = 0; i < (blueprint.Features?.Count ?? 0); i++)
        {
            FeatureBlueprint part = blueprint.Features![i];
            if (part is { Kind: FeatureKind.Antenna } && part.Ring > HeadLast)
            {
                problems.Add(FormattableString.Invariant($"features[{i}].ring"), NumberText.Of(part.Ring), FormattableString.Invariant($"at most {HeadLast}, on the head, of a body that forks"));
            }

            if (part is { Kind: FeatureKind.Tail } && part.Ring <= fork.Ring)
            {
                problems.Add(FormattableString.Invariant($"features[{i}].ring"), NumberText.Of(part.Ring), FormattableString.Invariant($"behind ring {fork.Ring}, where the body forks"));
            }
        }

        for (int i = 0; i < (blueprint.InsectWings?.Count ?? 0); i++)
        {
            if (blueprint.InsectWings![i]?.Ring <= fork.Ring)
            {
                problems.Add(FormattableString.Invariant($"insectWings[{i}].ring"), NumberText.Of(blueprint.InsectWings[i].Ring), FormattableString.Invariant($"behind ring {fork.Ring}, where the body forks"));
            }
        }
    }

    /// <summary>The last ring in front of all limbs at which a body can fork; −1 for none.</summary>
    public static int RingOf(CreatureBlueprint blueprint) => Math.Min(Usual, FirstLimb(blueprint) - 1) is int ring && ring >= Foremost ? ring : -1;

    /// <summary>The first ring of the foremost socket behind the head.</summary>
    private static int FirstLimb(CreatureBlueprint blueprint)
    {
        int first = BodyGrid.Rings;
        for (int i = 0; i < (blueprint.Legs?.Count ?? 0); i++)
        {
            first = Math.Min(first, blueprint.Legs![i]?.Socket?.Ring ?? first);
        }

        for (int i = 0; i < (blueprint.Wings?.Count ?? 0); i++)
        {
            first = Math.Min(first, blueprint.Wings![i]?.Socket?.Ring ?? first);
        }

        for (int i = 0; i < (blueprint.Fins?.Count ?? 0); i++)
        {
            first = Math.Min(first, blueprint.Fins![i]?.Socket?.Ring ?? first);
        }

        return first;
    }
}
