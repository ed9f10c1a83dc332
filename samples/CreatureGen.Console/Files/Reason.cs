using System;
using System.IO;

namespace CreatureGen.Console.Files;

/// <summary>Why a file could not be read or written, in a few words.</summary>
internal static class Reason
{
    // The system's own numbers: ENOSPC, EDQUOT, EROFS, EAGAIN, and ERROR_SHARING_VIOLATION, ERROR_HANDLE_DISK_FULL, ERROR_DISK_FULL.
    private const int NoSpace = 28;
    private const int NoQuota = 122;
    private const int ReadOnlyDisk = 30;
    private const int Held = 11;
    private const int SharingViolation = unchecked((int)0x80070020);
    private const int HandleDiskFull = unchecked((int)0x80070027);
    private const int DiskFull = unchecked((int)0x80070070);

    /// <summary>Whether an exception is one of those that files throw.</summary>
    public static bool IsOfFiles(Exception problem) => problem is IOException or UnauthorizedAccessException or NotSupportedException or System.Security.SecurityException;

    /// <summary>Whether another process holds the file.</summary>
    public static bool IsHeld(IOException problem) => problem.HResult is Held or SharingViolation;

    /// <summary>The words for an exception.</summary>
    public static string Of(Exception problem) => problem switch
    {
        FileNotFoundException => "there is no such file",
        DirectoryNotFoundException => "its folder does not exist",
        PathTooLongException => "the path is too long",
        UnauthorizedAccessException => "there is no permission",
        IOException { HResult: NoSpace or NoQuota or HandleDiskFull or DiskFull } => "the disk is full",
        IOException { HResult: ReadOnlyDisk } => "the disk is read-only",
        _ => FirstLine(problem.Message),
    };

    private static string FirstLine(string text)
    {
        int end = text.AsSpan().IndexOfAny('\r', '\n');
        return (end < 0 ? text : text[..end]).TrimEnd('.', ' ');
    }
}
