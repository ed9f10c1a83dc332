using System;
using System.Collections.Generic;

namespace CreatureGen.Motion.Metrics;

/// <summary>Courses of one act.</summary>
public static class ActScript
{
    private const float Before = 0.3f;
    private const float After = 0.7f;

    /// <summary>Seconds by which a phase that lasts is left late.</summary>
    private const float Lateness = 0.1f;

    /// <summary>A creature that stands performs an act, is told to go on where that is needed, and stands again.</summary>
    /// <param name="ability">The act.</param>
    /// <param name="target">What it goes for.</param>
    /// <exception cref="ArgumentNullException">There is no act.</exception>
    public static CourseScript Of(ActAbility ability, ActTarget target)
    {
        if (ability == null)
        {
            throw new ArgumentNullException(nameof(ability));
        }

        string name = ability.Act.Name;
        var commands = new List<CourseCommand> { new(Before, default) { Name = "stand" } };
        float lasting = ability.SecondsToLast;
        float rest = ability.Seconds + After;
        if (lasting > 0f)
        {
            commands.Add(new CourseCommand(lasting + Lateness, default) { Name = name, Act = ability, Target = target });
            commands.Add(new CourseCommand(rest - lasting, default) { Name = "go on", Order = ActOrder.GoOn });
        }
        else
        {
            commands.Add(new CourseCommand(rest, default) { Name = name, Act = ability, Target = target });
        }

        return new CourseScript(name, commands);
    }
}
