namespace UnityEngine.Experimental.Rendering;

[Flags]
public enum GraphicsFormatUsage { Blend = 32 }
