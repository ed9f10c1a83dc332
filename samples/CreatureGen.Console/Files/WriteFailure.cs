using System;

namespace CreatureGen.Console.Files;

/// <summary>A file that could not be written. The message is one line.</summary>
internal sealed class WriteFailure : Exception
{
    public WriteFailure(string message, Exception? inner = null)
        : base(message, inner)
    {
    }

    /// <summary>The failure of a path.</summary>
    public static WriteFailure At(string path, string reason, Exception? inner = null) => new($"cannot write '{path}': {reason}", inner);
}
