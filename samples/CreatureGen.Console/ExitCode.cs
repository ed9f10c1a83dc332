namespace CreatureGen.Console;

/// <summary>What the program says to the script that started it. These numbers are a contract.</summary>
internal static class ExitCode
{
    /// <summary>Done.</summary>
    public const int Done = 0;

    /// <summary>A check failed.</summary>
    public const int CheckFailed = 1;

    /// <summary>The arguments or an input file are wrong.</summary>
    public const int BadInput = 2;

    /// <summary>A file could not be written.</summary>
    public const int CannotWrite = 3;

    /// <summary>Stopped from outside: 128 and the number of the interrupt signal, as shells have it.</summary>
    public const int Interrupted = 130;
}
