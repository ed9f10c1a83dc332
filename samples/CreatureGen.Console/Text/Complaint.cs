using System.Collections.Generic;
using System.Linq;

namespace CreatureGen.Console.Text;

/// <summary>Tells people what went wrong, after the program's name.</summary>
internal static class Complaint
{
    /// <summary>One line, and one for each part of it.</summary>
    public static void Tell(Surroundings surroundings, params IReadOnlyList<string> lines)
    {
        Ink ink = Ink.For(surroundings, surroundings.ErrorIsTerminal);
        surroundings.Error.WriteLine(ink.Bad(Application.Name + ":") + " " + lines[0]);
        foreach (string line in lines.Skip(1))
        {
            surroundings.Error.WriteLine("  " + line);
        }
    }
}
