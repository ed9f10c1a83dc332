namespace CreatureGen.Console.Text;

/// <summary>Colours of letters on a terminal, or none.</summary>
internal sealed class Ink
{
    private readonly string bad;
    private readonly string good;
    private readonly string heading;
    private readonly string end;

    private Ink(string bad, string good, string heading, string end) => (this.bad, this.good, this.heading, this.end) = (bad, good, heading, end);

    /// <summary>Plain letters.</summary>
    public static Ink None { get; } = new("", "", "", "");

    private static Ink Ansi { get; } = new("\e[31m", "\e[32m", "\e[1m", "\e[0m");

    /// <summary>Colours if they go to a terminal whose owner has not said no to them (no-color.org).</summary>
    public static Ink For(Surroundings surroundings, bool terminal) => terminal && surroundings.AllowsColour ? Ansi : None;

    /// <summary>What is wrong.</summary>
    public string Bad(string text) => bad + text + end;

    /// <summary>What is right.</summary>
    public string Good(string text) => good + text + end;

    /// <summary>A heading.</summary>
    public string Heading(string text) => heading + text + end;
}
