using System;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;
using System.Threading;
using CreatureGen.Console.Files;

namespace CreatureGen.Console;

internal static class Program
{
    // What is in hand may go on for so long after a signal; then it is given up at its next clip or picture.
    private static readonly TimeSpan grace = TimeSpan.FromMilliseconds(200);

    private static int Main(string[] arguments)
    {
        using var stop = new CancellationTokenSource();
        using var abandon = new CancellationTokenSource();
        using PosixSignalRegistration interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Stop);
        using PosixSignalRegistration terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Stop);
        Stream data = StandardStreams.Output();
        var output = new StreamWriter(data, new UTF8Encoding(false), 1 << 14);
        var error = new StreamWriter(StandardStreams.Error(), new UTF8Encoding(false)) { AutoFlush = true };
        bool plain = !string.IsNullOrEmpty(Environment.GetEnvironmentVariable("NO_COLOR")) || Environment.GetEnvironmentVariable("TERM") == "dumb";
        return Application.Run(arguments, new Surroundings(output, error)
        {
            Data = data,
            Input = StandardStreams.Input,
            Variable = Environment.GetEnvironmentVariable,
            OutIsTerminal = !System.Console.IsOutputRedirected,
            ErrorIsTerminal = !System.Console.IsErrorRedirected,
            AllowsColour = !plain,
            Cancellation = stop.Token,
            Abandonment = abandon.Token,
        });

        // The first signal lets the work end tidily, the second one ends it as it is.
        void Stop(PosixSignalContext context)
        {
            context.Cancel = !stop.IsCancellationRequested;
            stop.Cancel();
            abandon.CancelAfter(grace);
        }
    }
}
