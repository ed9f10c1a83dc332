using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Metrics;

/// <summary>Commands one after the other, as a player gives them. Immutable.</summary>
public sealed class CourseScript
{
    /// <summary>Seconds by which a step may miss the time of a command: what sums of steps lose.</summary>
    private const double Slack = 1e-6;

    private readonly CourseCommand[] commands;
    private readonly double[] ends;

    /// <summary>Puts commands in order.</summary>
    /// <param name="name">What the script is called in reports.</param>
    /// <param name="commands">At least one.</param>
    /// <exception cref="ArgumentNullException">There is no name or there are no commands.</exception>
    /// <exception cref="ArgumentException">There is no command, or one has a time that is not within 1e-3..3600 or a number that is not finite; the message says which.</exception>
    public CourseScript(string name, IReadOnlyList<CourseCommand> commands)
    {
        Name = name ?? throw new ArgumentNullException(nameof(name));
        this.commands = (commands ?? throw new ArgumentNullException(nameof(commands))).ToArray();
        if (this.commands.Length == 0)
        {
            throw new ArgumentException("no commands; expected at least one", nameof(commands));
        }

        ends = new double[this.commands.Length];
        for (int i = 0; i < ends.Length; i++)
        {
            CourseCommand command = this.commands[i];
            Finite.RequireWithin(command.Seconds, 1e-3f, 3600f, FormattableString.Invariant($"{nameof(commands)}[{i}].{nameof(CourseCommand.Seconds)}"));
            foreach (float number in new[] { command.Input.Speed, command.Input.YawRate, command.Input.Sideways, command.Input.ClimbRate })
            {
                Finite.Require(number, FormattableString.Invariant($"{nameof(commands)}[{i}].{nameof(CourseCommand.Input)}"));
            }

            Seconds += command.Seconds;
            ends[i] = Seconds;
        }
    }

    /// <summary>What the script is called.</summary>
    public string Name { get; }

    /// <summary>The commands, in their order.</summary>
    public IReadOnlyList<CourseCommand> Commands => commands;

    /// <summary>How long they take together.</summary>
    public double Seconds { get; }

    /// <summary>Which command holds from a time on; the last for ever.</summary>
    /// <param name="seconds">Since the start.</param>
    public int IndexAt(double seconds)
    {
        int index = 0;
        while (index + 1 < ends.Length && seconds > ends[index] - Slack)
        {
            index++;
        }

        return index;
    }

    /// <summary>Whether a time is past the last command.</summary>
    /// <param name="seconds">Since the start.</param>
    public bool IsOver(double seconds) => seconds > Seconds - Slack;

    /// <inheritdoc/>
    public override string ToString() => Name;
}
