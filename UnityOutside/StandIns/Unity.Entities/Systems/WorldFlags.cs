namespace Unity.Entities;

[Flags]
public enum WorldFlags : int { None = 0, Live = 1, Editor = 3, Game = 5, Simulation = 9 }
