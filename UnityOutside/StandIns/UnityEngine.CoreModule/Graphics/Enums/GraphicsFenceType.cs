namespace UnityEngine.Rendering;

public enum GraphicsFenceType { AsyncQueueSynchronisation = 0, CPUSynchronisation = 1 }
