using System;
using System.Collections.Generic;

namespace CreatureGen.Console.Arguments;

/// <summary>Arguments or input that cannot be used.</summary>
internal class UsageError : Exception
{
    /// <summary>One line: what was wrong, where, what was expected.</summary>
    public UsageError(string message)
        : base(message) => Lines = [message];

    /// <summary>One line for the whole, and one for each part of it that is wrong.</summary>
    public UsageError(string message, IEnumerable<string> parts)
        : base(message) => Lines = [message, .. parts];

    /// <summary>The message, line by line.</summary>
    public IReadOnlyList<string> Lines { get; }
}
