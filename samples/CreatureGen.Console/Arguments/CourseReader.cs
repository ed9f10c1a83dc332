using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;

namespace CreatureGen.Console.Arguments;

/// <summary>Reads a script of commands such as <c>idle 1; walk; run 2; turn left at 1.5; stop</c> for a creature. Each command is a word, a side where it needs one, <c>at</c> a speed or rate, and seconds.</summary>
internal sealed class CourseReader
{
    private const float DefaultSeconds = 2f;
    private const float DefaultYaw = 1f;

    /// <summary>Seconds after the end of an act.</summary>
    private const float Afterwards = 0.5f;
    private const float MaxRate = 1000f;
    private const float MaxSeconds = 60f;

    // Parts of the speed ahead, where none is given.
    private const float ReverseFraction = 0.4f;
    private const float StrafeFraction = 0.4f;
    private const float ClimbFraction = 0.3f;

    private readonly MotionProfile profile;
    private readonly Dictionary<string, Movement> movements = new(StringComparer.Ordinal);
    private readonly Dictionary<string, Action<Words>> words = new(StringComparer.Ordinal);
    private MotionInput input;
    private bool escapes;
    private ActAbility? act;
    private ActOrder order;
    private BodyCommand body;

    private CourseReader(MotionProfile profile)
    {
        this.profile = profile;
        AddMovements();
        words.Add("idle", _ => input = new MotionInput(0f, Medium: input.Medium));
        words.Add("stop", _ => input = new MotionInput(0f, Medium: input.Medium));
        words.Add("act", command => act = ActArguments.Find(profile, command.Next(), command.Wrong));
        words.Add("go-on", _ => order = ActOrder.GoOn);
        words.Add("break-off", _ => order = ActOrder.Stop);
        words.Add("limp", _ => body = BodyCommand.GoLimp);
        words.Add("get-up", _ => body = BodyCommand.GetUp);
        words.Add("jump", _ => body = BodyCommand.Jump);
        words.Add("hit", command => body = command.Next() switch
        {
            "left" => BodyCommand.HitLeft,
            "right" => BodyCommand.HitRight,
            "front" => BodyCommand.HitFront,
            "behind" => BodyCommand.HitBehind,
            _ => throw command.Wrong("hit left, right, front or behind"),
        });
        words.Add("knock-down", _ => body = BodyCommand.KnockDown);
        words.Add("turn", command => input = input with { YawRate = command.Side() * command.At(DefaultYaw) });
        words.Add("straight", _ => input = input with { YawRate = 0f, Sideways = 0f, ClimbRate = 0f });
        words.Add("reverse", command => input = new MotionInput(-command.At(ReverseFraction * Pace()), Medium: input.Medium));
        if (profile.Gaits != null)
        {
            words.Add("strafe", command => input = new MotionInput(0f, Sideways: command.Side() * command.At(StrafeFraction * Pace())));
        }

        if (profile.Gaits == null || movements.Values.Any(movement => movement.Input.Medium == MotionMedium.Air))
        {
            words.Add("climb", command => input = input with { ClimbRate = command.At(ClimbFraction * Pace()) });
            words.Add("dive", command => input = input with { ClimbRate = -command.At(ClimbFraction * Pace()) });
        }
    }

    /// <summary>Reads a script.</summary>
    /// <param name="text">Commands with semicolons between; or <c>random</c>, <c>mixed</c>, <c>runner</c>, <c>keys</c> or <c>spin</c>, the scripts of <c>metrics --course</c>, with seconds.</param>
    /// <param name="profile">Whose words they are.</param>
    /// <exception cref="FormatException">It is none; the message says which command, and what was expected.</exception>
    public static CourseScript Read(string text, MotionProfile profile)
    {
        string[] parts = text.Split(';').Select(part => part.Trim()).ToArray();
        if (parts.Length == 1 && Measured(new Words(1, parts[0]), profile) is CourseScript measured)
        {
            return measured;
        }

        var reader = new CourseReader(profile);
        var commands = new List<CourseCommand>();
        for (int i = 0; i < parts.Length; i++)
        {
            // A semicolon at the end is no command.
            if (parts[i].Length > 0 || i + 1 < parts.Length || i == 0)
            {
                commands.Add(reader.Command(new Words(i + 1, parts[i])));
            }
        }

        if (commands.Sum(command => command.Seconds) > MaxSeconds)
        {
            throw new FormatException(FormattableString.Invariant($"the script takes {commands.Sum(command => command.Seconds):0.#} s; expected at most {MaxSeconds} s"));
        }

        return new CourseScript("course", commands);
    }

    private static CourseScript? Measured(Words command, MotionProfile profile)
    {
        Func<float, CourseScript>? script = command.Word switch
        {
            "random" => seconds => CourseScripts.Random(profile, seconds, 2.5f),
            "mixed" => seconds => CourseScripts.Mixed(profile, seconds),
            "runner" => seconds => CourseScripts.Runner(profile, seconds),
            "keys" => seconds => CourseScripts.Keys(profile, seconds),
            "spin" => _ => CourseScripts.Spin(profile),
            _ => null,
        };
        if (script == null)
        {
            return null;
        }

        float seconds = command.Seconds(12f, 1f, MaxSeconds - CourseScripts.RestSeconds);
        command.End();
        return script(seconds);
    }

    private CourseCommand Command(Words command)
    {
        escapes = false;
        body = BodyCommand.None;
        act = null;
        order = ActOrder.None;
        if (!words.TryGetValue(command.Word, out Action<Words>? apply))
        {
            string[] known = words.Keys.ToArray();
            throw command.Wrong("one of " + string.Join(", ", known) + Suggestion.For(command.Word, known));
        }

        apply(command);
        float seconds = command.Seconds(act?.Seconds + Afterwards ?? DefaultSeconds, 0.05f, MaxSeconds);
        command.End();
        MotionInput asked = input;
        input = escapes ? input with { Escape = EscapeTurn.None } : input;
        return new CourseCommand(seconds, asked) { Name = command.Name, Act = act, Order = order, Body = body };
    }

    /// <summary>Words for what the creature does by itself, at its own speed or at one that is given.</summary>
    private void AddMovements()
    {
        foreach (Movement movement in Movement.OfGoing(profile))
        {
            foreach (string name in new[] { movement.Name, movement.GaitName })
            {
                Add(MovementArguments.Hyphenated(name), movement);
            }
        }

        Movement[] gaits = movements.Values.Where(movement => movement.Gait != null).Distinct().ToArray();
        if (gaits.Length > 0)
        {
            Add("walk", gaits[0]);
            Add("run", gaits[^1]);
            Add("gallop", gaits.LastOrDefault(movement => movement.GaitName.EndsWith("Gallop", StringComparison.Ordinal)));
        }

        void Add(string word, Movement? movement)
        {
            if (movement != null && word != "idle" && movements.TryAdd(word, movement))
            {
                words.Add(word, command => Begin(movement, command));
            }
        }
    }

    private void Begin(Movement movement, Words command)
    {
        input = movement.Input with { Speed = command.At(movement.Input.Speed) };
        if (movement.Input.Escape != EscapeTurn.None)
        {
            input = input with { Escape = command.Side() > 0f ? EscapeTurn.Left : EscapeTurn.Right };
            escapes = true;
        }
    }

    /// <summary>The speed that the creature has been asked for, or that of its slowest movement.</summary>
    private float Pace() => input.Speed > 0f ? input.Speed : movements.Values.First(movement => movement.Input.Speed > 0f).Input.Speed;

    /// <summary>A command, word by word.</summary>
    private sealed class Words
    {
        private readonly int number;
        private readonly Queue<string> rest;

        public Words(int number, string text)
        {
            this.number = number;
            Name = text;
            rest = new Queue<string>(text.ToLowerInvariant().Split(' ', StringSplitOptions.RemoveEmptyEntries));
            Word = rest.TryDequeue(out string? word) ? word : "";
        }

        public string Word { get; }

        public string Name { get; }

        /// <summary>1 for left, −1 for right.</summary>
        public float Side() => rest.TryDequeue(out string? side) && side is "left" or "right" ? (side == "left" ? 1f : -1f) : throw Wrong($"{Word} left or {Word} right");

        /// <summary>The next word; empty for none.</summary>
        public string Next() => rest.TryDequeue(out string? word) ? word : "";

        /// <summary>What is given after <c>at</c>.</summary>
        public float At(float absent)
        {
            if (!rest.TryPeek(out string? at) || at != "at")
            {
                return absent;
            }

            rest.Dequeue();
            return Number(rest.TryDequeue(out string? text) ? text : "", 0f, MaxRate, "a number after at");
        }

        /// <summary>How long.</summary>
        public float Seconds(float absent, float min, float max) => rest.TryDequeue(out string? text) ? Number(text, min, max, "seconds") : absent;

        public void End()
        {
            if (rest.Count > 0)
            {
                throw Wrong($"nothing after the seconds, not '{string.Join(' ', rest)}'");
            }
        }

        public FormatException Wrong(string expectation) => new(FormattableString.Invariant($"command {number} '{Name}'; expected {expectation}"));

        private float Number(string text, float min, float max, string what) =>
            float.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out float value) && value >= min && value <= max
                ? value
                : throw Wrong(FormattableString.Invariant($"{what}, {min}..{max}"));
    }
}
