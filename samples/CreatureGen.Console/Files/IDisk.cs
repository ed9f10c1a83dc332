using System.IO;

namespace CreatureGen.Console.Files;

/// <summary>What writers ask of the file system. Each method may throw what files throw (<see cref="Reason.IsOfFiles"/>).</summary>
internal interface IDisk
{
    /// <summary>Makes a folder and those that it is in.</summary>
    void MakeFolder(string path);

    /// <summary>Makes a file that is not there yet.</summary>
    Stream Create(string path);

    /// <summary>Opens a file, made if it is missing, to write on at its end. Others may read it meanwhile.</summary>
    Stream Append(string path);

    /// <summary>The same, but nobody else can open it as long as it is open: a lock that ends with the process.</summary>
    Stream Hold(string path);

    /// <summary>Puts all that was written to a file that was made here on the disk itself, and closes it.</summary>
    void Keep(Stream file);

    /// <summary>Gives a file the permissions of another.</summary>
    void CopyPermissions(string from, string to);

    /// <summary>Gives a file another name in its folder; a file that has it is replaced in one step.</summary>
    void Rename(string from, string to);

    /// <summary>Removes a file; one that is not there is no failure.</summary>
    void Delete(string path);
}
